#include <chrono>
#include <memory>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/requests/memory_option.h"
#include "app/requests/points/cloud_columns.h"
#include "app/requests/points/row_list.h"
#include "app/results/fit/fit_report.h"

namespace artcal {
namespace {

struct Request {
  CommonOptions common;
  std::string points, rows;
  std::vector<int> columns;
  CloudLimits limits;
  FitWords words;
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

Expected<PointCloud> read_points(const Request& request, FitReport& report) {
  const auto columns = cloud_columns(request.columns);
  if (!columns) {
    return tl::unexpected(columns.error());
  }
  auto read = read_cloud(request.points, {report.request.unit_factor, {}}, *columns, request.limits);
  if (!read) {
    return tl::unexpected(read.error());
  }
  report.columns = read->columns;
  Expected<PointCloud> cloud = std::move(read->cloud);
  report.inputs.push_back(cloud->input);
  report.records = cloud->rows.size() + cloud->dropped;
  report.dropped = cloud->dropped;
  report.warnings = cloud->warnings;
  return request.rows.empty() ? cloud : take_rows(*cloud, request.rows, report.inputs);
}

Expected<int> fit_and_tell(const Request& request) {
  const auto start = Clock::now();
  FitReport report;
  auto understood = parse(request.words);
  if (!understood) {
    return tl::unexpected(understood.error());
  }
  report.request = std::move(*understood);
  const auto cloud = read_points(request, report);
  if (!cloud) {
    return tl::unexpected(cloud.error());
  }
  if (auto checked = check_outputs({request.common.json}, report.inputs); !checked) {
    return tl::unexpected(checked.error());
  }
  report.reading_seconds = seconds_since(start);
  auto fitted = fit_feature(*cloud, report.request);
  if (!fitted) {
    return tl::unexpected(fitted.error());
  }
  report.fit = std::move(*fitted);
  report.fitting_seconds = seconds_since(start) - report.reading_seconds;
  report.warnings.insert(report.warnings.end(), report.fit.warnings.begin(), report.fit.warnings.end());
  // Outliers may be many: only for who asks for them.
  return request.common.tell(request.common.json.empty() ? nlohmann::ordered_json() : to_json(report), to_text(report));
}

}  // namespace

Run set_up_fit(CLI::App& parser) {
  auto request = std::make_shared<Request>();
  FitWords& words = request->words;
  parser.add_option("points", request->points, "PCD, PLY, PTX, OBJ, STL or a table of x y z as text")
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
  add_columns_option(parser, request->columns);
  parser.add_option("--rows", request->rows, "fit only the rows (from 0) that this file lists, one a line")
      ->type_name("FILE");
  request->common.add_to(parser);
  add_max_memory(parser, request->limits);
  parser.footer(
      "Example:\n  artcal fit examples/points/ball.xyz --shape sphere --unit mm --json ball.json\n"
      "  artcal fit examples/points/ball-scan.pcd --shape sphere --unit m --diameter 25.4mm --robust");
  return [request] {
    const auto done = fit_and_tell(*request);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
