#include "acquisition/arm/arm_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "acquisition/arm/arm_text.h"
#include "acquisition/arm/covariance_matrix.h"
#include "acquisition/arm/joint_error_keys.h"
#include "acquisition/arm/parameters.h"
#include "core/files/text_file.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_document.h"
#include "core/toml/toml_text.h"
#include "core/unit_names.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr std::string_view arm_schema = "artcal-arm/1";
constexpr std::size_t fingerprints_a_line = 8;
constexpr double max_mechanical_coupling = 10.0;

Convention read_convention(TomlTable& root) {
  const std::string name = root.text("convention");
  if (name != "standard" && name != "modified") {
    root.fail("convention",
              fmt::format("convention is {}, expected \"standard\" or \"modified\" (Craig)", in_quotes(name)));
  }
  return name == "modified" ? Convention::Modified : Convention::Standard;
}

JointType read_type(TomlTable& table) {
  const std::string type = table.text_or("type", "revolute");
  if (type != "revolute" && type != "prismatic") {
    table.fail("type",
               fmt::format("the type of a joint is {}, expected \"revolute\" or \"prismatic\"", in_quotes(type)));
  }
  return type == "prismatic" ? JointType::Prismatic : JointType::Revolute;
}

// A prismatic joint has no encoder that turns, and no torque that bends it.
void check_joint(TomlTable& table, const Joint& joint) {
  if (!joint.is_prismatic()) {
    return;
  }
  const JointErrors& errors = joint.errors;
  const bool turns = errors.cosine != std::array<double, 2>{} || errors.sine != std::array<double, 2>{} ||
                     errors.coupling != 0.0 || errors.compliance != 0.0 || joint.mechanical_coupling != 0.0;
  if (turns) {
    table.fail("type",
               "a prismatic joint has no errors of an encoder that turns, no coupling and no compliance; it may have "
               "`gain` and `expansion_per_K`");
  }
}

Joint read_joint(TomlTable table, double length, double angle) {
  Joint joint;
  joint.type = read_type(table);
  joint.a = table.number("a") * length;
  joint.d = table.number("d") * length;
  joint.theta = table.number("theta") * angle;
  joint.alpha = table.number("alpha") * angle;
  joint.has_beta = table.has("beta");
  joint.beta = table.number_or("beta", 0.0) * angle;
  joint.sign = table.number_or("sign", 1.0);
  if (joint.sign != 1.0 && joint.sign != -1.0) {
    table.fail("sign", fmt::format("the sign of a joint is {}, expected 1 or -1", joint.sign));
  }
  const auto end_at = [&](std::string_view key) {
    return table.has(key) ? std::optional(table.number(key) * (joint.is_prismatic() ? length : angle)) : std::nullopt;
  };
  joint.lowest = end_at("min");
  joint.highest = end_at("max");
  if (joint.lowest && joint.highest && *joint.lowest >= *joint.highest) {
    table.fail("min", "`min` of a joint is not below its `max`");
  }
  joint.mechanical_coupling = table.number_or("mechanical_coupling", 0.0);
  if (!(std::abs(joint.mechanical_coupling) <= max_mechanical_coupling)) {
    table.fail("mechanical_coupling",
               fmt::format("`mechanical_coupling` is {}, expected -{} to {}; it is 1 or -1 where "
                           "a joint is stated against the ground",
                           joint.mechanical_coupling, max_mechanical_coupling, max_mechanical_coupling));
  }
  read_joint_errors(table, angle, joint);
  check_joint(table, joint);
  return joint;
}

Probe read_probe(TomlTable table, double length) {
  Probe probe;
  probe.name = table.name_or("name", probe.name);
  probe.radius = table.number_or("radius", 0.0) * length;
  probe.on_axis = table.has("l");
  if (probe.on_axis) {
    probe.tip_in_last.z() = table.number("l") * length;
    if (table.has("lx") || table.has("ly") || table.has("lz")) {
      table.fail("l", "a probe states its tip as `l` on the last axis or as `lx`, `ly`, `lz`, not both");
    }
  } else {
    probe.tip_in_last = length * Eigen::Vector3d(table.number("lx"), table.number("ly"), table.number("lz"));
  }
  if (probe.radius < 0.0) {
    table.fail("radius", "the radius of a tip is negative");
  }
  return probe;
}

void check_arm(const Arm& arm, TomlTable& root) {
  if (arm.joints.empty() || arm.joints.size() > max_joints) {
    root.fail("joint", fmt::format("the arm has {} joints, expected 1 to {} tables headed [[joint]]", arm.joints.size(),
                                   max_joints));
  }
  if (!has_masses(arm) && std::any_of(arm.joints.begin(), arm.joints.end(),
                                      [](const Joint& joint) { return joint.errors.compliance != 0.0; })) {
    root.fail("joint", "a joint bends under gravity, but not every joint states the mass of its link, `mass_kg`");
  }
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    const bool couples = joint.mechanical_coupling != 0.0 || (i > 0 && joint.errors.coupling != 0.0);
    if (couples && (i == 0 || arm.joints[i - 1].is_prismatic())) {
      root.fail("joint", fmt::format("joint {} is coupled to the joint before it, but {}", i + 1,
                                     i == 0 ? "it is the first" : "that one is prismatic"));
    }
  }
  if (arm.probes.empty()) {
    root.fail("probe", "the arm has no probe, expected at least one table headed [[probe]]");
  }
  std::set<std::string> names;
  for (const Probe& probe : arm.probes) {
    if (!names.insert(probe.name).second) {
      root.fail("probe", fmt::format("two probes are called {}; give each its own name", in_quotes(probe.name)));
    }
  }
}

std::optional<double> read_noise(TomlTable& table, std::string_view key) {
  const auto noise = table.optional_number(key);
  if (noise && *noise < 0.0) {
    table.fail(key, fmt::format("`{}`, the noise of a reading, is below zero", key));
  }
  return noise;
}

std::vector<std::string> read_fingerprints(TomlTable& table) {
  std::vector<std::string> fingerprints;
  for (const std::string& line : table.texts("readings")) {
    std::istringstream words(line);
    fingerprints.insert(fingerprints.end(), std::istream_iterator<std::string>(words), {});
  }
  std::sort(fingerprints.begin(), fingerprints.end());
  return fingerprints;
}

std::optional<ArmIdentification> read_identification(TomlTable table, const Arm& arm) {
  ArmIdentification known;
  known.program = table.name("program");
  known.recording = table.name("recording");
  known.parameters = table.texts("parameters");
  if (table.has("misfits")) {
    known.misfits = table.texts("misfits");
  }
  const auto rows = table.rows("covariance");
  known.noise = read_noise(table, "noise");
  known.encoder_noise = read_noise(table, "encoder_noise");
  known.probing_noise = read_noise(table, "probing_noise");
  if (known.encoder_noise.has_value() != known.probing_noise.has_value()) {
    table.fail("encoder_noise", "`encoder_noise` and `probing_noise` belong together; state both");
  }
  known.readings = read_fingerprints(table);
  if (table.has("unmodelled")) {
    known.unmodelled = table.number("unmodelled");
    if (!(known.unmodelled >= 1.0)) {
      table.fail("unmodelled", "the factor of the unmodelled error is below 1");
    }
  }
  const auto size = static_cast<Eigen::Index>(known.parameters.size());
  known.covariance.resize(size, size);
  const auto parameters = all_parameters(arm);
  std::set<std::string> seen;
  for (const auto& name : known.parameters) {
    if (find_parameter(parameters, name) < 0) {
      table.fail("parameters", fmt::format("{} is not a parameter of this arm", in_quotes(name)));
    } else if (!seen.insert(name).second) {
      table.fail("parameters", fmt::format("{} is there twice", in_quotes(name)));
    }
  }
  const auto fits = [size](const auto& row) { return static_cast<Eigen::Index>(row.size()) == size; };
  if (!fits(rows) || !std::all_of(rows.begin(), rows.end(), fits)) {
    table.fail("covariance", fmt::format("the covariance is not {} rows of {} numbers", size, size));
    return std::nullopt;
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    known.covariance.row(i) = Eigen::RowVectorXd::Map(rows[i].data(), size);
  }
  if (!is_covariance(known.covariance)) {
    table.fail("covariance",
               "the covariance is none: it is not symmetric, or some combination of parameters has a variance below "
               "zero");
  }
  return known;
}

std::string joint_text(const Joint& joint) {
  std::string text = fmt::format("[[joint]]\n{}a = {}\nd = {}\ntheta = {}  # {:.6f} deg\nalpha = {}  # {:.6f} deg\n",
                                 joint.is_prismatic() ? "type = \"prismatic\"\n" : "", toml_number(joint.a),
                                 toml_number(joint.d), toml_number(joint.theta), joint.theta / units::degree,
                                 toml_number(joint.alpha), joint.alpha / units::degree);
  if (joint.has_beta || joint.beta != 0.0) {
    text += fmt::format("beta = {}  # {:.6f} deg\n", toml_number(joint.beta), joint.beta / units::degree);
  }
  if (joint.sign < 0.0) {
    text += "sign = -1\n";
  }
  if (joint.mechanical_coupling != 0.0) {
    text += fmt::format("mechanical_coupling = {}\n", toml_number(joint.mechanical_coupling));
  }
  for (const auto& [key, end] : {std::pair{"min", joint.lowest}, std::pair{"max", joint.highest}}) {
    if (end) {
      text += fmt::format("{} = {}", key, toml_number(*end));
      text += joint.is_prismatic() ? "\n" : fmt::format("  # {:.6f} deg\n", *end / units::degree);
    }
  }
  return text + joint_errors_text(joint) + "\n";
}

std::string probe_text(const Probe& probe) {
  const auto& tip = probe.tip_in_last;
  const std::string place = probe.on_axis ? fmt::format("l = {}\n", toml_number(tip.z()))
                                          : fmt::format("lx = {}\nly = {}\nlz = {}\n", toml_number(tip.x()),
                                                        toml_number(tip.y()), toml_number(tip.z()));
  return fmt::format("[[probe]]\nname = {}\n{}radius = {}\n\n", toml_text(probe.name), place,
                     toml_number(probe.radius));
}

// Some on each line, so that the file stays readable.
std::string fingerprints_text(const std::vector<std::string>& fingerprints) {
  if (fingerprints.empty()) {
    return {};
  }
  std::string text =
      "# Fingerprints of the readings that it was identified from: `artcal verify` does not judge by these.\nreadings "
      "= [";
  for (std::size_t i = 0; i < fingerprints.size(); ++i) {
    text += i % fingerprints_a_line == 0 ? (i == 0 ? "\n  \"" : "\",\n  \"") : " ";
    text += fingerprints[i];
  }
  return text + "\",\n]\n";
}

std::string identification_text(const ArmIdentification& known) {
  std::string text = fmt::format(
      "# Covariance in the parameters' units (mm, rad, rad/rad, rad/(N mm), 1/K), in the order of "
      "`parameters`.\n[identified]\nprogram = {}\nrecording = "
      "{}\nparameters = [",
      toml_text(known.program), toml_text(known.recording));
  for (const auto& name : known.parameters) {
    text += toml_text(name) + ", ";
  }
  text += "]\n";
  if (known.noise) {
    text += fmt::format("noise = {}  # mm, of a reading's coordinate\n", toml_number(*known.noise));
  }
  if (!known.misfits.empty()) {
    text +=
        "# This arm does not fit its readings; it was written all the same, as asked (--accept-misfit).\nmisfits = [";
    for (const auto& reason : known.misfits) {
      text += toml_text(reason) + ", ";
    }
    text += "]\n";
  }
  if (known.encoder_noise && known.probing_noise) {
    text +=
        fmt::format("encoder_noise = {}  # rad, of each joint\nprobing_noise = {}  # mm, of a coordinate beside it\n",
                    toml_number(*known.encoder_noise), toml_number(*known.probing_noise));
  }
  if (known.unmodelled > 1.0) {
    text += fmt::format(
        "unmodelled = {}  # factor in the covariance's standard uncertainties: what placements left out showed beyond "
        "them\n",
        toml_number(known.unmodelled));
  }
  text += fingerprints_text(known.readings) + "covariance = [\n";
  for (const auto& row : known.covariance.rowwise()) {
    text += "  [";
    for (const double value : row) {
      text += toml_number(value) + ", ";
    }
    text += "],\n";
  }
  return text + "]\n";
}

Expected<ArmFile> arm_file_of(Expected<TomlDocument> document, const std::filesystem::path& path) {
  if (!document) {
    return tl::unexpected(document.error());
  }
  TomlTable& root = document->root();
  ArmFile result;
  result.input = {path.string(), document->sha256()};
  Arm& arm = result.arm;
  arm.name = root.name_or("name", truncated(80, path.stem().string()));
  arm.convention = read_convention(root);
  read_surroundings(root, arm);
  TomlTable units = root.table("units");
  const double length = length_unit(units, "length");
  const double angle = angle_unit(units, "angle");
  for (auto& table : root.tables("joint")) {
    arm.joints.push_back(read_joint(table, length, angle));
  }
  for (auto& table : root.tables("probe")) {
    arm.probes.push_back(read_probe(table, length));
  }
  check_arm(arm, root);
  if (root.has("identified")) {
    result.identification = read_identification(root.table("identified"), arm);
  }
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  return result;
}

}  // namespace

Expected<ArmFile> read_arm_file(const std::filesystem::path& path) {
  return arm_file_of(TomlDocument::read(path, arm_schema), path);
}

Expected<Arm> arm_of_text(const std::string& text, const std::string& name) {
  return arm_file_of(TomlDocument::parse({name, text, ""}, arm_schema), name).map([](ArmFile&& file) {
    return std::move(file.arm);
  });
}

std::string arm_file_text(const Arm& arm, const std::optional<ArmIdentification>& identification) {
  std::string text = fmt::format(
      "schema = \"{}\"\nname = {}\nconvention = \"{}\"\nunits = {{ length = \"mm\", angle = \"rad\" }}\n{}\n",
      arm_schema, toml_text(arm.name), arm.convention == Convention::Modified ? "modified" : "standard",
      surroundings_text(arm));
  for (const Joint& joint : arm.joints) {
    text += joint_text(joint);
  }
  for (const Probe& probe : arm.probes) {
    text += probe_text(probe);
  }
  return identification ? text + identification_text(*identification) : text;
}

}  // namespace artcal
