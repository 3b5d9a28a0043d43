#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/output/table.h"
#include "app/results/fit/fit_report.h"
#include "core/statistics.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr std::size_t max_points_listed = 10;

std::string title(const FitReport& report) {
  const FitRequest& request = report.request;
  std::string text = fmt::format("{}\n{}, {}", truncated(200, report.inputs.front().path), name_of(request.shape),
                                 name_of(request.options.criterion));
  if (request.options.fixed_radius) {
    text += fmt::format(", diameter {:.6g} mm as stated", 2.0 * *request.options.fixed_radius);
  }
  if (request.options.circle_normal) {
    text += ", normal as stated";
  }
  if (request.options.tip_radius > 0.0) {
    text += fmt::format(", {} by a tip of {:.6g} mm", request.options.side == Side::Inside ? "inside" : "outside",
                        2.0 * request.options.tip_radius);
  }
  text += fmt::format(": {} of {} points", report.fit.points, report.records);
  if (report.dropped > 0) {
    text += fmt::format(", {} not numbers", report.dropped);
  }
  if (!report.fit.outliers.empty()) {
    text += fmt::format(", {} left out", report.fit.outliers.size());
  }
  return fmt::format("{}\nx, y, z from {}\n\n", text, report.columns);
}

// Lengths to 0.01 µm, directions to what such a length is at 10 m, angles in degrees.
std::string shown(const FeatureValue& value) {
  return value.unit == "mm"    ? fmt::format("{:.5f}", value.value)
         : value.unit == "rad" ? fmt::format("{:.7f}", value.value / units::degree)
                               : fmt::format("{:.9f}", value.value);
}

std::string shown_u(const FeatureValue& value) {
  return value.u ? fmt::format("{:.2g}", *value.u / (value.unit == "rad" ? units::degree : 1.0)) : "";
}

std::string values_text(const FitReport& report) {
  const FeatureFit& fit = report.fit;
  Table table({"", "unit", "result", fit.covariance ? "u (k = 1)" : ""});
  const auto row = [&](const FeatureValue& value) {
    const bool stated = value.name == "diameter" && report.request.options.fixed_radius;
    table.add({value.name, value.unit == "rad" ? "deg" : value.unit, shown(value), stated ? "stated" : shown_u(value)});
  };
  for (const FeatureValue& value : fit.values) {
    row(value);
  }
  if (fit.free_diameter) {
    FeatureValue free = *fit.free_diameter;
    free.name = "diameter, free";
    row(free);
  }
  table.add({"form", "mm", fmt::format("{:.5f}", fit.form), ""});
  table.add({"rms", "mm", fmt::format("{:.5f}", fit.rms), ""});
  return table.text() + "\n";
}

std::string noise_text(const FitReport& report) {
  const FeatureFit& fit = report.fit;
  std::string text =
      fmt::format("  form is the range from {:+.5f} mm at row {} to {:+.5f} mm at row {} (rows from 0)\n",
                  fit.lowest.mm, fit.lowest.row, fit.highest.mm, fit.highest.row);
  if (fit.covariance && fit.noise) {
    text += fmt::format("  u follows from a noise of {:.3g} mm a point, {}\n", *fit.noise,
                        report.request.options.noise
                            ? "as stated"
                            : fmt::format("estimated with {} degrees of freedom: U (95 %) is {:.3g} u",
                                          fit.degrees_of_freedom, stated_coverage_factor(fit.degrees_of_freedom)));
  } else if (report.request.options.criterion == Criterion::LeastSquares) {
    text += "  no uncertainty: there are no more points than the feature needs, and no --noise is stated\n";
  } else {
    text += "  no uncertainty: the answer rests on the few outermost points\n";
  }
  return text + "\n";
}

std::string outliers_text(const FeatureFit& fit) {
  if (fit.outliers.empty()) {
    return {};
  }
  std::string text =
      fmt::format("Left out as outliers: {} of {} points\n", fit.outliers.size(), fit.outliers.size() + fit.points);
  for (std::size_t i = 0; i < std::min(max_points_listed, fit.outliers.size()); ++i) {
    text += fmt::format("  row {}: {:+.5f} mm\n", fit.outliers[i].row, fit.outliers[i].mm);
  }
  if (fit.outliers.size() > max_points_listed) {
    text += fmt::format("  and {} more, all in the JSON result\n", fit.outliers.size() - max_points_listed);
  }
  return text + "\n";
}

}  // namespace

std::string to_text(const FitReport& report) {
  std::string text = title(report) + values_text(report) + noise_text(report) + outliers_text(report.fit) +
                     warning_lines(report.warnings);
  while (text.ends_with("\n\n")) {
    text.pop_back();
  }
  return text;
}

}  // namespace artcal
