#include "app/results/identification/result_json.h"

#include <cmath>

#include "app/output/json_list.h"
#include "app/results/artefact_summary.h"
#include "app/results/evaluation/evaluation_json.h"
#include "app/results/identification/coupling_json.h"
#include "app/results/identification/model_json.h"
#include "app/results/identification/readings_json.h"
#include "app/results/result_head.h"
#include "app/results/result_names.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

const char* quantity_name(ArtefactParameter::Quantity quantity) {
  switch (quantity) {
    case ArtefactParameter::Quantity::ErrorX: return "x";
    case ArtefactParameter::Quantity::ErrorY: return "y";
    case ArtefactParameter::Quantity::ErrorZ: return "z";
    case ArtefactParameter::Quantity::Radius: break;
  }
  return "radius";
}

Json parameters_json(const Identification& result) {
  Json json = Json::array();
  for (const IdentifiedParameter& parameter : result.parameters) {
    const bool identified = parameter.state == ParameterState::Identified || parameter.state == ParameterState::Weak;
    json.push_back({{"name", parameter.parameter.name},
                    {"unit", parameter.parameter.unit()},
                    {"nominal", parameter.nominal},
                    {"identified", parameter.identified},
                    {"standard_uncertainty", identified ? Json(parameter.u) : Json(nullptr)},
                    {"degrees_of_freedom", identified && std::isfinite(parameter.degrees_of_freedom)
                                               ? Json(parameter.degrees_of_freedom)
                                               : Json(nullptr)},
                    {"coverage_factor", identified ? Json(parameter.coverage_factor()) : Json(nullptr)},
                    {"state", result_name(parameter.state)}});
  }
  return json;
}

Json artefact_value_json(const ArtefactValue& value) {
  const bool certified = value.certified.has_value();
  return {{"artefact", value.artefact},
          {"feature", value.feature},
          {"quantity", quantity_name(value.quantity)},
          {"certified_mm", certified ? Json(*value.certified) : Json(nullptr)},
          {"certified_standard_uncertainty_mm", certified ? Json(value.u_certified) : Json(nullptr)},
          {"found_mm", value.found},
          {"standard_uncertainty_mm", value.u}};
}

Json certificate_outlier_json(const CertificateOutlier& outlier) {
  const bool is_distance = !outlier.quantity;
  return {{"artefact", outlier.name.artefact},
          {"placement", is_distance ? Json(outlier.name.placement) : Json(nullptr)},
          {"feature", outlier.name.feature},
          {"second", is_distance ? Json(outlier.second) : Json(nullptr)},
          {"quantity", is_distance ? "distance" : quantity_name(*outlier.quantity)},
          {"certified_mm", outlier.certified},
          {"certified_standard_uncertainty_mm", outlier.u},
          {"deviation_mm", outlier.deviation},
          {"standardised", outlier.standardised},
          {"limit", outlier.limit},
          {"weight", outlier.weight}};
}

Json influence_json(const ArtefactInfluence& influence) {
  const bool certified = influence.certificates > 0;
  return {{"artefact", influence.artefact},
          {"readings", influence.readings},
          {"readings_weight", influence.readings_weight},
          {"certificates", influence.certificates},
          {"certificates_weight", certified ? Json(influence.certificates_weight) : Json(nullptr)},
          {"share", influence.share}};
}

Json covariance_json(const Identification& result) {
  Json names = Json::array();
  for (const int index : result.free) {
    names.push_back(result.parameters[index].parameter.name);
  }
  Json rows = Json::array();
  for (const auto& row : result.covariance.rowwise()) {
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return {{"parameters", names}, {"units", "mm, rad, rad/rad, rad/(N mm), 1/K"}, {"matrix", rows}};
}

Json noise_json(const IdentifyOptions& options, const Identification& result) {
  Json json{{"given", result.noise_is_given}, {"mm", result.noise}};
  if (options.noise.encoder) {
    json["encoder_rad"] = *options.noise.encoder;
    json["probing_mm"] = *options.noise.probing;
  }
  json["chi_squared"] = result.chi_squared;
  json["degrees_of_freedom"] = result.degrees_of_freedom;
  json["chi_squared_95"] = {result.chi_squared_low, result.chi_squared_high};
  json["scale_factor"] = result.scale_factor;
  return json;
}

Json cross_validation_json(const CrossValidation& found) {
  if (found.placements == 0) {
    return nullptr;
  }
  return {{"placements", found.placements},
          {"effective_placements", found.effective_placements},
          {"predictions", found.predictions},
          {"ratio", found.ratio},
          {"ratio_99", found.limit},
          {"point_error_mm", found.point_error},
          {"scale", found.scale}};
}

}  // namespace

Json result_header(const Recording& recording, const char* kind, const std::optional<std::uint64_t>& seed) {
  Json json = result_head(kind);
  json["recording"] = recording.name;
  json["arm"] = recording.arm.name;
  json["inputs"] = inputs_json(recording.inputs);
  json["seed"] = seed ? Json(*seed) : Json(nullptr);
  return json;
}

Json to_json(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
             const Identification& result, const Timings& timings) {
  Json json = result_header(recording, "identification", std::nullopt);
  json["options"] = {{"hold", options.hold},
                     {"free", options.free},
                     {"loss", result_name(options.loss)},
                     {"leave_out", options.leave_out}};
  json["counts"] = {{"readings", recording.readings.size()},
                    {"features", constraints.features.size()},
                    {"placements", result.after.placements.size()},
                    {"artefacts", result.after.artefacts.size()}};
  json["model"] = model_json(result);
  json["date"] = recording.date.empty() ? Json(nullptr) : Json(recording.date);
  json["temperature"] = temperature_json(recording);
  json["artefacts"] = artefacts_json(constraints.artefacts);
  json["coupling"] = coupling_json(result.coupling);
  json["parameters"] = parameters_json(result);
  json["covariance"] = covariance_json(result);
  json["noise"] = noise_json(options, result);
  json["artefact_values"] = json_list(result.artefact_values, artefact_value_json);
  json["before"] = evaluation_json(result.before);
  json["after"] = evaluation_json(result.after);
  json["left_out"] = json_list(result.left_out, left_out_json);
  json["cross_validation"] = cross_validation_json(result.cross_validation);
  json["outliers"] = json_list(result.outliers, [&](const Outlier& outlier) -> Json {
    return {{"reading", outlier.reading},
            {"where", recording.where(outlier.reading)},
            {"artefact", outlier.name.artefact},
            {"placement", outlier.name.placement},
            {"feature", outlier.name.feature},
            {"standardised", outlier.standardised},
            {"limit", outlier.limit},
            {"deviation_mm", outlier.deviation},
            {"deviation_is_signed", outlier.is_signed},
            {"weight", outlier.weight}};
  });
  json["certificate_outliers"] = json_list(result.certificate_outliers, certificate_outlier_json);
  json["influence"] = json_list(result.influences, influence_json);
  json["model_study"] = model_study_json(result.model_study);
  json["termination"] = {{"status", result.misfits.empty() ? "converged" : "misfit accepted"},
                         {"message", result.termination},
                         {"iterations", result.iterations},
                         {"rounds", result.noise_rounds},
                         {"cost", result.cost},
                         {"initial_alignment", name_of(result.alignment)},
                         {"attempts", result.attempts},
                         {"misfits", result.misfits}};
  json["warnings"] = result.warnings;
  json["arm_shape"] = arm_shape_json(recording, result.arm);
  json["timings_s"] = {{"reading", timings.reading}, {"identifying", timings.identifying}};
  return json;
}

}  // namespace artcal
