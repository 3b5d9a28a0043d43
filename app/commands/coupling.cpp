#include <algorithm>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/recording/tip_centres.h"
#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/requests/model_asked.h"
#include "app/requests/named_values.h"
#include "app/requests/recording_request.h"
#include "app/results/identification/coupling_json.h"
#include "app/results/identification/coupling_text.h"
#include "app/results/identification/result_json.h"
#include "artefacts/constraints/document_warnings.h"
#include "artefacts/virtual_probing/virtual_probing.h"
#include "core/files/size_limits.h"
#include "core/toml/toml_document.h"
#include "identification/identifiability/coupling.h"
#include "identification/identifiability/selection.h"
#include "identification/problem/start.h"

namespace artcal {
namespace {

struct CouplingArguments {
  CommonOptions common;
  RecordingRequest input;  ///< or an arm
  std::vector<std::string> hold, free;
  std::string model;
  double angle_scale = 0.0;
  VirtualProbing probing;
  bool kind_is_given = false;
};

Expected<BoundRecording> made_up(const CouplingArguments& arguments) {
  auto file = read_arm_file(arguments.input.path);
  if (!file) {
    return tl::unexpected(file.error());
  }
  VirtualRecording made = probe_virtually(file->arm, arguments.probing);
  const auto wanted = static_cast<std::size_t>(arguments.probing.readings);
  // An odd number of readings leaves one that makes no pair.
  if (made.recording.readings.size() < std::max<std::size_t>(1, wanted - wanted % 2)) {
    return no_solution(
        fmt::format("only {} of {} readings of this kind can be made up: a distance takes two readings, and the arm "
                    "must reach what it is to read",
                    made.recording.readings.size(), wanted));
  }
  made.recording.name = fmt::format("{} readings at random postures", made.recording.readings.size());
  made.recording.inputs = {file->input};
  auto constraints = build_constraints(made.recording, made.artefacts);
  if (!constraints) {
    return tl::unexpected(constraints.error());
  }
  return BoundRecording{std::move(made.recording), std::move(*constraints)};
}

Expected<BoundRecording> recorded(const RecordingRequest& request) {
  auto recording = request.read();
  if (!recording) {
    return tl::unexpected(recording.error());
  }
  if (auto there = require_joints(*recording); !there) {
    return tl::unexpected(there.error());
  }
  return request.bind(std::move(*recording)).map([](BoundRecording&& bound) {
    auto& warnings = bound.recording.warnings;
    warnings.insert(warnings.end(), bound.constraints.warnings.begin(), bound.constraints.warnings.end());
    const auto of_documents = texts_of(document_warnings(bound.recording, bound.constraints.artefacts));
    warnings.insert(warnings.end(), of_documents.begin(), of_documents.end());
    return std::move(bound);
  });
}

// Readings, real or made up.
Expected<BoundRecording> subject_of(const CouplingArguments& arguments) {
  const auto file = read_text_file(arguments.input.path, largest::toml);
  if (!file) {
    return tl::unexpected(file.error());
  }
  const bool is_arm = schema_of(*file).starts_with("artcal-arm/");
  if (is_arm && !arguments.kind_is_given) {
    return wrong_usage(
        "this is an arm without readings; say which kind of reading to think of, such as --kind base "
        "(see artcal coupling --help)");
  }
  if (!is_arm && arguments.kind_is_given) {
    if (const auto document = TomlDocument::parse(*file, "artcal-recording/1"); !document) {
      return tl::unexpected(document.error());
    }
    return wrong_usage("--kind is for an arm alone; this file is a recording, whose readings say what they are");
  }
  return is_arm ? made_up(arguments) : recorded(arguments.input);
}

Expected<Model> model_of(const CouplingArguments& arguments, const Recording& recording) {
  const auto model = model_asked(arguments.model, recording);
  if (!model) {
    return tl::unexpected(model.error());
  }
  if (model->automatic && !arguments.model.empty()) {
    return wrong_usage("a coupling analysis is of one model; state its groups, such as --model dh+eccentricity");
  }
  for (const ParameterGroup group : model->groups) {
    if (const std::string obstacle = obstacle_to(group, recording.arm, recording); !obstacle.empty()) {
      return wrong_usage(fmt::format("the model has the group {}, but {}", name_of(group), obstacle));
    }
  }
  return model->groups;
}

Expected<int> analyse_and_tell(const CouplingArguments& arguments) {
  const auto subject = subject_of(arguments);
  if (!subject) {
    return tl::unexpected(subject.error());
  }
  const auto& [recording, constraints] = *subject;
  if (auto checked = arguments.input.check_outputs({arguments.common.json}, recording); !checked) {
    return tl::unexpected(checked.error());
  }
  std::vector<std::string> hold = recording.identify.hold;
  hold.insert(hold.end(), arguments.hold.begin(), arguments.hold.end());
  std::vector<std::string> free = recording.identify.free;
  free.insert(free.end(), arguments.free.begin(), arguments.free.end());
  const auto model = model_of(arguments, recording);
  if (!model) {
    return tl::unexpected(model.error());
  }
  const Arm nominal = arm_for(*model, recording.arm);
  const auto selection = select_parameters(nominal, hold, free, *model);
  if (!selection) {
    return tl::unexpected(selection.error());
  }
  const auto arm = arm_with_fitted_tips(recording, constraints, nominal, hold);
  if (!arm) {
    return tl::unexpected(arm.error());
  }
  CouplingOptions options = coupling_options(*selection);
  options.angle_scale = arguments.angle_scale;
  options.noise = recording.noise;
  const auto coupling = analyse_coupling(recording, constraints, *arm, options);
  if (!coupling) {
    return tl::unexpected(with_warnings(coupling.error(), recording.warnings));
  }
  const auto made_up = arguments.kind_is_given ? std::optional(arguments.probing) : std::nullopt;
  return arguments.common.tell(to_json(recording, *coupling, {hold, free, model_text(*model), made_up}),
                               to_text(recording, *coupling));
}

}  // namespace

Run set_up_coupling(CLI::App& parser) {
  auto arguments = std::make_shared<CouplingArguments>();
  parser.add_option("input", arguments->input.path, "recording.toml, or arm.toml with --kind")
      ->required()
      ->type_name("RECORDING|ARM");
  const std::map<std::string, ReadingKind> kinds{
      {"base", ReadingKind::BaseCoordinates}, {"frame", ReadingKind::FrameCoordinates},
      {"plate", ReadingKind::Plate},          {"point", ReadingKind::Point},
      {"distance", ReadingKind::Distance},    {"sphere", ReadingKind::Sphere},
      {"plane", ReadingKind::Plane},          {"plane-perpendicular", ReadingKind::LevelPlane},
      {"length", ReadingKind::Length},        {"sphere-unknown-radius", ReadingKind::UnknownSphere}};
  auto* kind = parser.add_option("--kind", arguments->probing.kind,
                                 "for an arm alone, the kind of reading: base (known coordinates in the base frame), "
                                 "frame (in an unknown frame), plate (a known pattern at unknown poses), point "
                                 "(seats), distance (pairs at a certified distance), sphere (balls of known radius), "
                                 "sphere-unknown-radius, plane (unknown planes; --features 1 for a single one), "
                                 "plane-perpendicular (all perpendicular to axis 1), length (to unknown anchors)");
  kind->transform(named_values(kinds))->type_name("KIND")->default_str("");
  parser.add_option("--readings", arguments->probing.readings, "how many, at random postures")
      ->check(CLI::Range(1, 10'000'000))
      ->needs(kind);
  parser
      .add_option("--features", arguments->probing.features,
                  "points, balls, planes or anchors, or placements of a plate, they are spread over")
      ->check(CLI::Range(1, 100'000))
      ->needs(kind);
  parser.add_option("--seed", arguments->probing.seed, "of the random postures")->needs(kind);
  parser.add_option("--hold", arguments->hold, "parameters taken as known")->delimiter(',')->type_name("NAMES");
  parser.add_option("--free", arguments->free, "parameters that are to be free where there is a choice")
      ->delimiter(',')
      ->type_name("NAMES");
  parser
      .add_option("--model", arguments->model,
                  "parameters asked about: dh, or dh with groups behind it, such as dh+eccentricity (see identify)")
      ->type_name("MODEL");
  parser
      .add_option("--angle-scale", arguments->angle_scale,
                  "mm that make an angle a length; the arm's reach if not given")
      ->check(CLI::PositiveNumber);
  arguments->input.options.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer(
      "Examples:\n  artcal coupling examples/two-socket-bar/recording.toml\n"
      "  artcal coupling examples/gao2013/table1.toml --kind distance");
  return [arguments, kind] {
    arguments->kind_is_given = kind->count() > 0;
    const auto done = analyse_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
