#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/csv/csv_text.h"
#include "acquisition/recording/tip_centres.h"
#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/output/phrases.h"
#include "app/requests/recording_request.h"
#include "app/results/identification/result_json.h"

namespace artcal {
namespace {

struct PointsArguments {
  CommonOptions common;
  RecordingRequest recording;
  std::string arm, output = "-";
};

// Readings of coordinates, in mm: a table that another recording can name.
std::string points_text(const Recording& recording, const TipCentres& tips) {
  std::string text = "artefact,placement,feature,orientation,repeat,probe,temperature,x,y,z\n";
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    const Reading& r = recording.readings[i];
    for (const auto& name : {recording.artefacts.name(r.artefact), recording.placements.name(r.placement),
                             recording.features.name(r.feature), recording.orientations.name(r.orientation),
                             recording.repeats.name(r.repeat), recording.arm.probes[r.probe].name}) {
      text += csv_field(name) + ",";
    }
    const auto p = tips.in_base.col(static_cast<Eigen::Index>(i));
    text += std::isfinite(r.temperature) ? fmt::format("{}", r.temperature) : "";
    text += fmt::format(",{},{},{}\n", p.x(), p.y(), p.z());
  }
  return text;
}

nlohmann::ordered_json points_json(const Recording& recording, const TipCentres& tips, const std::string& arm) {
  nlohmann::ordered_json json = result_header(recording, "points", std::nullopt);
  json["arm"] = arm;
  json["warnings"] = recording.warnings;
  json["points"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    const Reading& r = recording.readings[i];
    const auto p = tips.in_base.col(static_cast<Eigen::Index>(i));
    json["points"].push_back({{"where", recording.where(static_cast<int>(i))},
                              {"artefact", recording.artefacts.name(r.artefact)},
                              {"placement", recording.placements.name(r.placement)},
                              {"feature", recording.features.name(r.feature)},
                              {"tip_mm", {p.x(), p.y(), p.z()}}});
  }
  return json;
}

// Points of scans are readings once the artefact is found among them.
Expected<Recording> read_with_scans(const RecordingRequest& request) {
  return request.read().and_then([&](Recording&& recording) -> Expected<Recording> {
    if (recording.scans.empty()) {
      return std::move(recording);
    }
    return request.bind(std::move(recording)).map([](BoundRecording&& bound) { return std::move(bound.recording); });
  });
}

Expected<int> write_points(const PointsArguments& arguments) {
  auto recording = read_with_scans(arguments.recording);
  if (!recording) {
    return tl::unexpected(recording.error());
  }
  std::optional<Arm> arm;
  std::optional<ArmIdentification> identification;
  if (!arguments.arm.empty()) {
    auto file = read_arm_file(arguments.arm);
    if (!file) {
      return tl::unexpected(file.error());
    }
    recording->inputs.push_back(file->input);
    arm = std::move(file->arm);
    identification = std::move(file->identification);
  }
  if (auto checked = arguments.recording.check_outputs({arguments.output, arguments.common.json}, *recording);
      !checked) {
    return tl::unexpected(checked.error());
  }
  const auto tips = tip_centres(*recording, arm ? *arm : recording->arm, identification ? &*identification : nullptr);
  if (!tips) {
    return tl::unexpected(with_warnings(tips.error(), recording->warnings));
  }
  const std::string& name = arm ? arm->name : recording->arm.name;
  if (auto written = write_json(arguments.common.json, points_json(*recording, *tips, name)); !written) {
    return tl::unexpected(written.error());
  }
  const std::string text = points_text(*recording, *tips);
  if (arguments.output == "-") {
    if (arguments.common.talks()) {
      fmt::print(stderr, "{}", warning_lines(recording->warnings));
      fmt::print("{}", text);
    }
    return 0;
  }
  if (auto written = write_file(arguments.output, text); !written) {
    return tl::unexpected(written.error());
  }
  if (arguments.common.talks()) {
    fmt::print("{} points are in {}, in mm in the base frame of the arm \"{}\".\n{}", recording->readings.size(),
               arguments.output, name, warning_lines(recording->warnings));
  }
  return 0;
}

}  // namespace

Run set_up_points(CLI::App& parser) {
  auto arguments = std::make_shared<PointsArguments>();
  arguments->recording.add_path_to(parser);
  parser
      .add_option("--arm", arguments->arm, "the arm to compute with, such as an identified one; else the recording's")
      ->type_name("ARM");
  parser.add_option("-o,--output", arguments->output, "CSV of the tip's centres; - is standard output")
      ->type_name("FILE");
  arguments->recording.options.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer("Example:\n  artcal points examples/ball-bar/recording.toml -o points.csv");
  return [arguments] {
    const auto done = write_points(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
