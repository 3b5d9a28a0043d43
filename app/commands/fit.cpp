#include <memory>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/output/stopwatch.h"
#include "app/requests/memory_option.h"
#include "app/requests/points/cloud_columns.h"
#include "app/requests/points/row_list.h"
#include "app/results/fit/fit_report.h"

namespace artcal {
namespace {

struct FitArguments {
  CommonOptions common;
  std::string points, rows;
  std::vector<int> columns;
  CloudLimits limits;
  FitWords words;
};

Expected<PointCloud> read_points(const FitArguments& arguments, FitReport& report) {
  const auto columns = cloud_columns(arguments.columns);
  if (!columns) {
    return tl::unexpected(columns.error());
  }
  auto read = read_cloud(arguments.points, {report.request.unit_factor, {}}, *columns, arguments.limits);
  if (!read) {
    return tl::unexpected(read.error());
  }
  report.columns = read->columns;
  Expected<PointCloud> cloud = std::move(read->cloud);
  report.inputs.push_back(cloud->input);
  report.records = cloud->rows.size() + cloud->dropped;
  report.dropped = cloud->dropped;
  report.warnings = cloud->warnings;
  return arguments.rows.empty() ? cloud : take_rows(*cloud, arguments.rows, report.inputs);
}

Expected<int> fit_and_tell(const FitArguments& arguments) {
  const Stopwatch watch;
  FitReport report;
  auto understood = parse(arguments.words);
  if (!understood) {
    return tl::unexpected(understood.error());
  }
  report.request = std::move(*understood);
  const auto cloud = read_points(arguments, report);
  if (!cloud) {
    return tl::unexpected(cloud.error());
  }
  if (auto checked = check_outputs({arguments.common.json}, report.inputs); !checked) {
    return tl::unexpected(checked.error());
  }
  report.reading_seconds = watch.seconds();
  auto fitted = fit_feature(*cloud, report.request);
  if (!fitted) {
    return tl::unexpected(fitted.error());
  }
  report.fit = std::move(*fitted);
  report.fitting_seconds = watch.seconds() - report.reading_seconds;
  report.warnings.insert(report.warnings.end(), report.fit.warnings.begin(), report.fit.warnings.end());
  // Outliers may be many: only for who asks for them.
  return arguments.common.tell(arguments.common.json.empty() ? nlohmann::ordered_json() : to_json(report),
                               to_text(report));
}

}  // namespace

Run set_up_fit(CLI::App& parser) {
  auto arguments = std::make_shared<FitArguments>();
  FitWords& words = arguments->words;
  parser.add_option("points", arguments->points, "PCD, PLY, PTX, OBJ, STL or a table of x y z as text")
      ->required()
      ->type_name("POINTS");
  parser.add_option("--shape", words.shape, "what the points lie on")->required()->check(CLI::IsMember(shape_names()));
  parser.add_option("--unit", words.unit, "unit of the coordinates in the file: mm, um, m or in")->required();
  parser.add_option("--criterion", words.criterion, "what fits best")->check(CLI::IsMember(criterion_names()));
  parser.add_option("--diameter", words.diameter, "sphere: its diameter is known, such as \"25.4 mm\"");
  parser.add_option("--tip-diameter", words.tip_diameter, "the points are centres of a tip of this diameter");
  parser.add_flag("--inside", words.inside, "the tip touched from inside, as in a bore");
  parser.add_option("--towards", words.towards, "normals and directions point this way; write --towards=-1,0,0")
      ->delimiter(',')
      ->type_name("X,Y,Z");
  parser.add_option("--normal", words.normal, "circle: the normal of its plane is known; write --normal=0,0,1")
      ->delimiter(',')
      ->type_name("X,Y,Z");
  parser.add_flag("--spatial", words.spatial, "circle: distances to the curve in space, not first onto its plane");
  parser.add_option("--noise", words.noise, "noise of a point, such as \"15 um\"; else estimated");
  parser.add_flag("--robust", words.robust, "find outliers, list them, fit the rest");
  add_columns_option(parser, arguments->columns);
  parser.add_option("--rows", arguments->rows, "fit only the rows (from 0) that this file lists, one a line")
      ->type_name("FILE");
  arguments->common.add_to(parser);
  add_max_memory(parser, arguments->limits);
  parser.footer(
      "Example:\n  artcal fit examples/points/ball.xyz --shape sphere --unit mm --json ball.json\n"
      "  artcal fit examples/points/ball-scan.pcd --shape sphere --unit m --diameter 25.4mm --robust");
  return [arguments] {
    const auto done = fit_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
