#include "artefacts/simulation/plan/plan_file.h"

#include <cmath>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/arm/joint_error_keys.h"
#include "artefacts/artefact/artefact_file.h"
#include "artefacts/simulation/plan/plan_arm.h"
#include "artefacts/simulation/plan/plan_keys.h"
#include "artefacts/simulation/plan/plan_session.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_document.h"

namespace artcal {
namespace {

constexpr std::string_view schema = "artcal-plan/1";
constexpr double max_seed = 9007199254740992.0;  // 2^53: beyond it not every whole number is a double

std::uint64_t read_seed(TomlTable& root) {
  const double seed = root.number_or("seed", 1.0);
  if (!(seed >= 0.0 && seed <= max_seed && seed == std::floor(seed))) {
    root.fail("seed", fmt::format("the seed is {}, expected a whole number from 0 to 2^53", seed));
    return 1;
  }
  return static_cast<std::uint64_t>(seed);
}

Expected<void> read_arms(const std::filesystem::path& folder, const std::string& true_arm, PlanFile& file) {
  auto nominal = read_arm_file(file.arm);
  if (!nominal) {
    return tl::unexpected(nominal.error());
  }
  file.inputs.push_back(nominal->input);
  file.plan.nominal = nominal->arm;
  file.plan.arm.arm = nominal->arm;
  if (!true_arm.empty()) {
    auto real = read_arm_file(folder / true_arm);
    if (!real) {
      return tl::unexpected(real.error());
    }
    file.inputs.push_back(real->input);
    file.plan.arm.arm = std::move(real->arm);
  }
  return {};
}

Expected<void> read_artefacts(const FileAccess& access, PlanFile& file) {
  for (const auto& path : file.artefacts) {
    auto artefact = read_artefact_file(path, access);
    if (!artefact) {
      return tl::unexpected(artefact.error());
    }
    for (const PlannedArtefact& other : file.plan.artefacts) {
      if (other.certified.name == artefact->artefact.name) {
        return bad_input(fmt::format("two artefacts of this plan are called {}", in_quotes(other.certified.name)),
                         path.string());
      }
    }
    file.inputs.push_back(artefact->input);
    if (artefact->certificate) {
      file.inputs.push_back(*artefact->certificate);
    }
    file.certificates.push_back({artefact->certificate_name, artefact->certificate ? artefact->certificate->path : ""});
    std::vector<TrueFeature> stated(artefact->artefact.features.size());
    file.plan.artefacts.push_back({std::move(artefact->artefact), std::move(stated)});
  }
  return {};
}

void read_session(TomlTable& root, SimulationPlan& plan) {
  TomlTable names = root.table("units");
  const PlanUnits units{length_unit(names, "length"), angle_unit(names, "angle")};
  check_same_kind(root, plan.nominal, plan.arm.arm);
  plan.errors = read_arm_errors(root.table("errors"), plan.arm.arm);
  TomlTable noise = root.table("noise");
  plan.noise = read_planned_noise(noise);
  read_virtual_joints(root, plan.arm, units.angle, angle_at(noise, "encoder"));
  if (!root.has("gravity_m_s2") && plan.nominal.gravity_in_base != plan.arm.arm.gravity_in_base) {
    root.fail("true_arm",
              "the arm and the true arm are mounted in different ways (`gravity_m_s2` of their files); state "
              "in this plan which one holds");
  }
  read_gravity(root, plan.nominal);
  plan.arm.arm.gravity_in_base = plan.nominal.gravity_in_base;
  plan.draw_artefacts = root.truth_or("artefact_errors", false);
  read_true_features(root, plan, units);
  read_stand(root, plan, units);
  read_placements(root, plan, units);
  read_probings(root, plan, units);
}

}  // namespace

Expected<PlanFile> read_plan_file(const std::filesystem::path& path) {
  return read_plan_file(path, FileAccess::anywhere());
}

Expected<PlanFile> read_plan_file(const std::filesystem::path& path, const FileAccess& access) {
  auto document = TomlDocument::read(path, schema);
  if (!document) {
    return tl::unexpected(document.error());
  }
  TomlTable& root = document->root();
  const std::filesystem::path folder = path.parent_path();
  PlanFile file;
  file.inputs.push_back({path.string(), document->sha256()});
  file.plan.name = root.name_or("name", truncated(80, path.stem().string()));
  file.plan.seed = read_seed(root);
  const auto file_at = [&](std::string_view key, const std::string& name) {
    const auto found = access.resolve(folder, name, root.where(key));
    if (!found) {
      root.fail(key, found.error().message);
    }
    return found.value_or(std::filesystem::path{});
  };
  file.arm = file_at("arm", root.text("arm"));
  const std::string true_arm = root.text_or("true_arm", "");
  if (!true_arm.empty()) {
    file_at("true_arm", true_arm);
  }
  for (const auto& name : root.texts("artefacts")) {
    file.artefacts.push_back(file_at("artefacts", name));
  }
  if (file.artefacts.empty()) {
    root.fail("artefacts", "the plan names no artefact, expected artefacts = [\"artefact.toml\"]");
  }
  if (auto noted = document->so_far(); !noted) {
    return tl::unexpected(noted.error());
  }
  if (auto arms = read_arms(folder, true_arm, file); !arms) {
    return tl::unexpected(arms.error());
  }
  if (auto artefacts = read_artefacts(access, file); !artefacts) {
    return tl::unexpected(artefacts.error());
  }
  read_session(root, file.plan);
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  return file;
}

}  // namespace artcal
