#include <charconv>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "acquisition/point_cloud/point_cloud.h"
#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/requests/access_option.h"
#include "app/requests/memory_option.h"
#include "app/requests/points/cloud_columns.h"
#include "app/results/fit/segment_result.h"
#include "artefacts/artefact/artefact_file.h"
#include "core/text/in_quotes.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

struct SegmentArguments {
  CommonOptions common;
  AccessOption access;
  std::string scan, artefact, unit;
  std::string tolerance;
  std::string radius = "fixed";
  std::vector<std::string> places;
  std::vector<int> columns;
  std::optional<double> temperature;
  CloudLimits limits;
};

// "NAME=x,y,z"; names may hold an equals sign themselves.
Expected<PlaceHint> hint_of(const std::string& text, const SegmentResult& result) {
  const auto wrong = [&] {
    return wrong_usage(
        fmt::format("--place {}: expected the name of a sphere of the artefact and where it is, in {}, such as "
                    "{}=10,-20,35.5",
                    in_quotes(text), result.unit, sphere_name(result, 0)));
  };
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) {
    return wrong();
  }
  PlaceHint hint;
  hint.point = -1;
  for (std::size_t i = 0; i < result.wanted.spheres.size(); ++i) {
    if (sphere_name(result, i) == text.substr(0, equals)) {
      hint.point = static_cast<int>(i);
    }
  }
  const char* at = text.data() + equals + 1;
  const char* const end = text.data() + text.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto [next, error] = std::from_chars(at, end, hint.near(axis));
    const bool goes_on = axis < 2 ? next != end && *next == ',' : next == end;
    if (error != std::errc() || !goes_on || !std::isfinite(hint.near(axis))) {
      return wrong();
    }
    at = next + 1;
  }
  if (hint.point < 0) {
    return wrong();
  }
  hint.near *= result.unit_in_mm;
  return hint;
}

Expected<SegmentOptions> segment_options_of(const SegmentArguments& arguments, const SegmentResult& result) {
  SegmentOptions options;
  options.fixed_radius = arguments.radius == "fixed";
  if (!arguments.tolerance.empty()) {
    options.tolerance = length_quantity(arguments.tolerance);
    if (!options.tolerance || *options.tolerance <= 0.0) {
      return wrong_usage("a tolerance is a number above zero with its unit, such as --tolerance \"0.5 mm\"");
    }
  }
  if (!arguments.places.empty() && result.wanted.spheres.empty()) {
    return wrong_usage("--place names a sphere, but the artefact has none");
  }
  for (const std::string& place : arguments.places) {
    auto hint = hint_of(place, result);
    if (!hint) {
      return tl::unexpected(hint.error());
    }
    options.hints.push_back(*hint);
  }
  return options;
}

Expected<int> segment_and_tell(const SegmentArguments& arguments) {
  SegmentResult result;
  const auto unit = length_unit(arguments.unit);
  if (!unit) {
    return wrong_usage(fmt::format("--unit {}: expected mm, um, m or in", in_quotes(arguments.unit)));
  }
  result.unit = arguments.unit;
  result.unit_in_mm = *unit;
  constexpr double absolute_zero = -273.15;
  if (arguments.temperature && !(*arguments.temperature > absolute_zero && *arguments.temperature < 1e4)) {
    return wrong_usage("--temperature: expected the artefact's temperature in degC, such as 20.5");
  }
  auto artefact = read_artefact_file(arguments.artefact, arguments.access.of(arguments.artefact));
  if (!artefact) {
    return tl::unexpected(artefact.error());
  }
  result.artefact = std::move(artefact->artefact);
  result.temperature = arguments.temperature.value_or(result.artefact.reference_temperature);
  auto wanted = scan_contents(result.artefact, result.temperature);
  if (!wanted) {
    return bad_input(wanted.error().message, arguments.artefact);
  }
  result.wanted = std::move(*wanted);
  auto options = segment_options_of(arguments, result);
  if (!options) {
    return tl::unexpected(options.error());
  }
  result.options = std::move(*options);
  const auto columns = cloud_columns(arguments.columns);
  if (!columns) {
    return tl::unexpected(columns.error());
  }
  auto read = read_cloud(arguments.scan, {*unit, std::nullopt}, *columns, arguments.limits);
  if (!read) {
    return tl::unexpected(read.error());
  }
  result.columns = read->columns;
  PointCloud* const cloud = &read->cloud;
  result.inputs = {cloud->input, artefact->input};
  if (artefact->certificate) {
    result.inputs.push_back(*artefact->certificate);
  }
  if (auto checked = check_outputs({arguments.common.json}, result.inputs); !checked) {
    return tl::unexpected(checked.error());
  }
  result.points = static_cast<std::size_t>(cloud->points.cols());
  result.rows = std::move(cloud->rows);
  auto segmentation = segment(cloud->points, result.wanted.contents, result.options);
  if (!segmentation) {
    return tl::unexpected(segmentation.error());
  }
  result.segmentation = std::move(*segmentation);
  result.warnings = std::move(cloud->warnings);
  result.warnings.insert(result.warnings.end(), result.segmentation.warnings.begin(),
                         result.segmentation.warnings.end());
  const SegmentStatus status = result.segmentation.status;
  if (status != SegmentStatus::Complete && status != SegmentStatus::Partial) {
    return no_solution(refusal_text(result));
  }
  // The rows of millions of points: only for who asks for them.
  return arguments.common.tell(arguments.common.json.empty() ? nlohmann::ordered_json() : to_json(result),
                               to_text(result));
}

}  // namespace

Run set_up_segment(CLI::App& parser) {
  auto arguments = std::make_shared<SegmentArguments>();
  parser.add_option("scan", arguments->scan, "PCD, PLY, PTX, OBJ, STL or text of x, y, z")
      ->required()
      ->type_name("SCAN");
  parser.add_option("--artefact", arguments->artefact, "artefact.toml: the artefact that was scanned")
      ->required()
      ->type_name("FILE");
  parser.add_option("--unit", arguments->unit, "of the scan's coordinates: mm, um, m or in")
      ->required()
      ->type_name("UNIT");
  parser.add_option("--temperature", arguments->temperature, "of the artefact, in degC; else the certificate's");
  parser.add_option("--tolerance", arguments->tolerance,
                    "of distances between spheres, such as \"0.5 mm\"; else a tenth of the radius");
  parser.add_option("--radius", arguments->radius, "of the fitted spheres: the certified one, or what the points show")
      ->check(CLI::IsMember({"fixed", "free"}));
  parser.add_option("--place", arguments->places, "which sphere is which, where distances do not show it: NAME=x,y,z")
      ->type_name("PLACE");
  add_columns_option(parser, arguments->columns);
  arguments->access.add_to(parser);
  arguments->common.add_to(parser);
  add_max_memory(parser, arguments->limits);
  parser.footer(
      "Example:\n  artcal segment examples/ball-bar-scan/scan.xyz --unit mm\\\n"
      "    --artefact examples/ball-bar-scan/bar.toml");
  return [arguments] {
    const auto done = segment_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
