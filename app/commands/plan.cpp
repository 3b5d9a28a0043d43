#include <map>
#include <memory>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/recording/tip_centres.h"
#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/requests/named_values.h"
#include "app/requests/recording_request.h"
#include "app/requests/referenced_files.h"
#include "app/requests/stand_options.h"
#include "app/requests/stated_noise.h"
#include "app/results/planning/plan_result.h"
#include "artefacts/artefact/artefact_file.h"
#include "artefacts/simulation/plan/plan_file.h"
#include "artefacts/simulation/possible_session.h"
#include "core/files/size_limits.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_document.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

struct PlanArguments {
  CommonOptions common;
  RecordingOptions access;
  std::string input;
  std::string artefact;
  std::string measured;
  std::string encoder_noise, probing_noise;
  std::string table, picture;
  StandOptions stand;
  PossibleSession possible{100, 20, 1};
  PlanningOptions options;
};

/// What could be read, and the files that say so.
struct Possible {
  SimulationPlan plan;
  std::vector<InputFile> inputs;
};

Expected<Possible> possible_of_arm(const PlanArguments& arguments) {
  if (arguments.artefact.empty()) {
    return wrong_usage("this is an arm; say what is to be read with it: --artefact artefact.toml");
  }
  auto arm = read_arm_file(arguments.input);
  if (!arm) {
    return tl::unexpected(arm.error());
  }
  auto artefact = read_artefact_file(arguments.artefact, arguments.access.of(arguments.artefact));
  if (!artefact) {
    return tl::unexpected(artefact.error());
  }
  std::vector<InputFile> inputs{arm->input, artefact->input};
  if (artefact->certificate) {
    inputs.push_back(*artefact->certificate);
  }
  return Possible{possible_session(arm->arm, artefact->artefact, arguments.possible), std::move(inputs)};
}

// The placements and probings of a plan.toml, its true arm and noise forgotten.
Expected<Possible> possible_of_plan(const PlanArguments& arguments) {
  if (!arguments.artefact.empty()) {
    return wrong_usage("--artefact is for an arm alone; this plan names its artefacts itself");
  }
  auto file = read_plan_file(arguments.input, arguments.access.of(arguments.input));
  if (!file) {
    return tl::unexpected(file.error());
  }
  SimulationPlan plan = file->plan;
  plan.arm.arm = plan.nominal;
  for (VirtualJoint& joint : plan.arm.joints) {
    const VirtualJoint real = joint;
    joint = VirtualJoint{};
    joint.low = real.low;
    joint.high = real.high;
  }
  plan.errors = {};
  plan.noise = {};
  plan.draw_artefacts = false;
  return Possible{std::move(plan), file->inputs};
}

Expected<Possible> possible_of(const PlanArguments& arguments) {
  const auto file = read_text_file(arguments.input, largest::toml);
  if (!file) {
    return tl::unexpected(file.error());
  }
  if (schema_of(*file).starts_with("artcal-arm/")) {
    return possible_of_arm(arguments);
  }
  // Before anything is said of options: it may be no plan at all.
  if (const auto document = TomlDocument::parse(*file, "artcal-plan/1"); !document) {
    return tl::unexpected(document.error());
  }
  return possible_of_plan(arguments);
}

Expected<Noise> noise_of(const PlanArguments& arguments) {
  const auto encoder = stated_angle_noise(arguments.encoder_noise, "--encoder-noise");
  if (!encoder) {
    return tl::unexpected(encoder.error());
  }
  const auto probing = stated_length_noise(arguments.probing_noise, "--probing-noise");
  if (!probing) {
    return tl::unexpected(probing.error());
  }
  Noise noise;
  noise.encoder = *encoder;
  noise.probing = *probing;
  return noise;
}

// Readings that are there already.
Expected<std::optional<BoundRecording>> measured_of(const PlanArguments& arguments, const Arm& arm) {
  if (arguments.measured.empty()) {
    return std::nullopt;
  }
  const RecordingRequest measured{arguments.measured, arguments.access};
  auto recording = measured.read();
  if (!recording) {
    return tl::unexpected(recording.error());
  }
  if (auto there = require_joints(*recording); !there) {
    return tl::unexpected(there.error());
  }
  if (recording->arm.joints.size() != arm.joints.size() || recording->arm.convention != arm.convention ||
      recording->arm.probes.size() != arm.probes.size()) {
    return bad_input(
        fmt::format("these readings were taken with the arm {}, which is not built like the arm {} that is "
                    "to be planned for",
                    in_quotes(recording->arm.name), in_quotes(arm.name)),
        arguments.measured);
  }
  return measured.bind(std::move(*recording)).map([](BoundRecording&& bound) {
    return std::optional(std::move(bound));
  });
}

Expected<int> plan_and_tell(const PlanArguments& arguments) {
  auto possible = possible_of(arguments);
  if (!possible) {
    return tl::unexpected(possible.error());
  }
  PlanningOptions options = arguments.options;
  const auto noise = noise_of(arguments);
  if (!noise) {
    return tl::unexpected(noise.error());
  }
  options.noise = *noise;
  const auto measured = measured_of(arguments, possible->plan.nominal);
  if (!measured) {
    return tl::unexpected(measured.error());
  }
  std::vector<InputFile> inputs = possible->inputs;
  if (*measured) {
    const auto& more = (*measured)->recording.inputs;
    inputs.insert(inputs.end(), more.begin(), more.end());
  }
  std::vector<InputFile> to_be_kept =
      *measured ? referenced_files((*measured)->recording, arguments.access.of(arguments.measured))
                : std::vector<InputFile>{};
  to_be_kept.insert(to_be_kept.end(), inputs.begin(), inputs.end());
  if (auto checked = check_outputs({arguments.common.json, arguments.table, arguments.picture}, to_be_kept); !checked) {
    return tl::unexpected(checked.error());
  }
  if (auto stable = arguments.stand.add_to(possible->plan.stand); !stable) {
    return tl::unexpected(stable.error());
  }
  const auto simulation = simulate(possible->plan);
  if (!simulation) {
    return tl::unexpected(simulation.error());
  }
  std::vector<Artefact> artefacts;
  for (const PlannedArtefact& artefact : possible->plan.artefacts) {
    artefacts.push_back(artefact.certified);
  }
  const auto constraints = build_constraints(simulation->recording, std::move(artefacts));
  if (!constraints) {
    return tl::unexpected(constraints.error());
  }
  const auto planning = plan_session(*simulation, *constraints, *measured ? &(*measured)->recording : nullptr,
                                     *measured ? &(*measured)->constraints : nullptr, options);
  if (!planning) {
    return tl::unexpected(planning.error());
  }
  const PlanResult result{possible->plan, *simulation,
                          *planning,      options,
                          inputs,         *measured ? static_cast<int>((*measured)->recording.readings.size()) : 0};
  for (const auto& [path, text] :
       {std::pair(arguments.table, to_csv(result)), {arguments.picture, to_picture(result)}}) {
    if (auto written = path.empty() ? Expected<void>{} : write_file(path, text); !written) {
      return tl::unexpected(written.error());
    }
  }
  return arguments.common.tell(to_json(result), to_text(result));
}

}  // namespace

Run set_up_plan(CLI::App& parser) {
  auto arguments = std::make_shared<PlanArguments>();
  parser
      .add_option("input", arguments->input,
                  "the arm (identified or nominal), or plan.toml with the placements that are possible")
      ->required()
      ->type_name("ARM|PLAN");
  parser.add_option("--artefact", arguments->artefact, "artefact.toml, for an arm")->type_name("FILE");
  parser.add_option("--placements", arguments->options.placements, "how many to choose")->check(CLI::Range(1, 1000));
  parser.add_option("--readings", arguments->options.readings, "of each feature in each of them")
      ->check(CLI::Range(1, 10'000));
  parser.add_option("--measured", arguments->measured, "recording.toml with readings that are there already")
      ->type_name("RECORDING");
  parser.add_option("--encoder-noise", arguments->encoder_noise, "noise of each joint, such as \"2 arcsec\"")
      ->required();
  parser
      .add_option("--probing-noise", arguments->probing_noise,
                  "noise of the tip's coordinates beside the joints', such as \"3 um\"")
      ->required();
  const std::map<std::string, Goal> goals{{"worst", Goal::Worst}, {"mean", Goal::Mean}};
  parser.add_option("--goal", arguments->options.goal, "the u of lengths to lower")
      ->transform(named_values(goals))
      ->type_name("GOAL")
      ->default_str("worst");
  parser
      .add_option("--possible", arguments->possible.placements,
                  "for an arm: placements to choose from, drawn at random")
      ->check(CLI::Range(1, 5000));
  parser
      .add_option("--postures", arguments->possible.readings, "for an arm: possible readings of each feature in each")
      ->check(CLI::Range(1, 10'000));
  arguments->stand.add_to(parser);
  parser
      .add_option("-o,--output", arguments->table,
                  "table of the readings to take: joint angles, and how the artefact stands (position and turn as in "
                  "plan.toml)")
      ->type_name("CSV");
  parser.add_option("--picture", arguments->picture, "the placements proposed, as SVG")->type_name("SVG");
  parser.add_option("--starts", arguments->options.starts, "random starts of the exchange")->check(CLI::Range(1, 1000));
  parser.add_option("--seed", arguments->options.seed, "of all that is drawn");
  arguments->access.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer(
      "Example:\n  artcal plan examples/ball-bar/arm.toml --artefact examples/ball-bar/bar.toml --placements 4\\\n"
      "    --encoder-noise \"2 arcsec\" --probing-noise \"3 um\" --floor \"-700 mm\" --picture plan.svg");
  return [arguments] {
    arguments->possible.seed = arguments->options.seed;
    const auto done = plan_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
