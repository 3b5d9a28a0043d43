#include <limits>

#include "app/results/fit/fit_report.h"
#include "app/results/result_head.h"
#include "core/statistics.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json diameter_of(const std::optional<double>& radius) { return radius ? Json(2.0 * *radius) : Json(nullptr); }

Json fit_options_json(const FitRequest& request) {
  const FitOptions& options = request.options;
  const auto vector_or_null = [](const std::optional<Eigen::Vector3d>& vector) {
    return vector ? Json(std::vector<double>(vector->begin(), vector->end())) : Json(nullptr);
  };
  return {{"shape", name_of(request.shape)},
          {"unit", request.unit},
          {"criterion", name_of(options.criterion)},
          {"diameter_mm", diameter_of(options.fixed_radius)},
          {"tip_diameter_mm", 2.0 * options.tip_radius},
          {"side", options.side == Side::Inside ? "inside" : "outside"},
          {"circle", options.circle == CircleConvention::Spatial ? "spatial" : "projected"},
          {"normal", vector_or_null(options.circle_normal)},
          {"towards", vector_or_null(options.towards)},
          {"noise_mm", or_null(options.noise)},
          {"robust", request.robust}};
}

Json value_json(const FeatureValue& value) {
  return {
      {"name", value.name}, {"unit", value.unit}, {"value", value.value}, {"standard_uncertainty", or_null(value.u)}};
}

// Of the standard uncertainties: 2 where the noise was stated.
Json coverage_factor_json(const FitReport& report) {
  if (!report.fit.covariance) {
    return nullptr;
  }
  return stated_coverage_factor(report.request.options.noise ? std::numeric_limits<double>::infinity()
                                                             : report.fit.degrees_of_freedom);
}

Json covariance_json(const FeatureFit& fit) {
  if (!fit.covariance) {
    return nullptr;
  }
  Json rows = Json::array();
  for (const auto& row : fit.covariance->rowwise()) {
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return {{"parameters", fit.parameters}, {"units", "mm, rad"}, {"matrix", rows}};
}

Json deviation_json(const RowDeviation& deviation) { return {{"row", deviation.row}, {"deviation_mm", deviation.mm}}; }

}  // namespace

Json to_json(const FitReport& report) {
  const FeatureFit& fit = report.fit;
  Json json = result_head("fit");
  json["inputs"] = inputs_json(report.inputs);
  json["seed"] = report.request.robust ? Json(0) : Json(nullptr);
  json["options"] = fit_options_json(report.request);
  json["columns"] = report.columns;
  json["counts"] = {{"records", report.records},
                    {"dropped", report.dropped},
                    {"fitted", fit.points},
                    {"outliers", fit.outliers.size()}};
  json["values"] = Json::array();
  for (const FeatureValue& value : fit.values) {
    json["values"].push_back(value_json(value));
  }
  json["free_diameter"] = fit.free_diameter ? value_json(*fit.free_diameter) : Json(nullptr);
  json["covariance"] = covariance_json(fit);
  json["form_mm"] = fit.form;
  json["rms_mm"] = fit.rms;
  json["noise_mm"] = or_null(fit.noise);
  json["degrees_of_freedom"] = fit.degrees_of_freedom;
  json["coverage_factor"] = coverage_factor_json(report);
  json["lowest"] = deviation_json(fit.lowest);
  json["highest"] = deviation_json(fit.highest);
  json["outliers"] = Json::array();
  for (const RowDeviation& outlier : fit.outliers) {
    json["outliers"].push_back(deviation_json(outlier));
  }
  json["steps"] = fit.steps;
  json["warnings"] = report.warnings;
  json["timings_s"] = {{"reading", report.reading_seconds}, {"fitting", report.fitting_seconds}};
  return json;
}

}  // namespace artcal
