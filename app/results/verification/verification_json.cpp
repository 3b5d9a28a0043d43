#include "app/results/verification/verification_json.h"

#include <cmath>

#include "app/output/json_list.h"
#include "app/output/text_or_null.h"
#include "app/results/artefact_summary.h"
#include "app/results/identification/readings_json.h"
#include "app/results/identification/result_json.h"
#include "app/results/result_names.h"
#include "app/results/verification/feature_places.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json budget_json(const Budget& budget) {
  return {{"calibration_mm", budget.calibration},
          {"expansion_mm", budget.expansion},
          {"temperature_mm", budget.temperature},
          {"alignment_mm", budget.alignment},
          {"fixture_mm", budget.fixture},
          {"form_mm", budget.form},
          {"points_mm", budget.points}};
}

Json place_json(const Place& place) {
  return {{"point_mm", {place.point_in_base.x(), place.point_in_base.y(), place.point_in_base.z()}},
          {"octant", place.octant},
          {"share_of_reach", place.share_of_reach},
          {"above_base", place.above_base},
          {"joint_at_stop", place.joint_at_stop > 0 ? Json(place.joint_at_stop) : Json(nullptr)}};
}

Json value_json(const TestValue& value) {
  return {{"quantity", artcal::name_of(value.quantity)},
          {"artefact", value.artefact},
          {"placement", value.placement},
          {"first", value.first},
          {"second", text_or_null(value.second)},
          {"repeat", value.repeat},
          {"certified_mm", value.certified > 0.0 ? Json(value.certified) : Json(nullptr)},
          {"stated_mm", value.second.empty() ? Json(nullptr) : Json(value.stated.value)},
          {"stated_at_C", value.second.empty() ? Json(nullptr) : Json(value.stated.temperature)},
          {"measured_mm", value.measured},
          {"value_mm", value.value},
          {"temperature_C", number_or_null(value.temperature)},
          {"limit_mm", value.limit ? Json(*value.limit) : Json(nullptr)},
          {"u_mm", value.budget.total()},
          {"degrees_of_freedom", number_or_null(value.budget.degrees_of_freedom())},
          {"dilution", value.dilution.worst > 0.0 ? Json(value.dilution.worst) : Json(nullptr)},
          {"budget", budget_json(value.budget)},
          {"verdict", result_name(value.verdict)},
          {"set_aside", value.set_aside},
          {"place", place_json(value.place)}};
}

Json plate_json(const PlatePlacement& plate) {
  Json balls = Json::array();
  for (const BallResidual& ball : plate.balls) {
    balls.push_back(
        {{"feature", ball.feature},
         {"residual_mm", {ball.residual_in_plate.x(), ball.residual_in_plate.y(), ball.residual_in_plate.z()}},
         {"standardised", ball.standardised},
         {"stands_out", ball.is_outlier}});
  }
  return {{"artefact", plate.artefact},
          {"placement", plate.placement},
          {"repeat", plate.repeat},
          {"temperature_C", number_or_null(plate.temperature)},
          {"rms_mm", plate.rms},
          {"limit", plate.limit},
          {"scale_ppm", 1e6 * plate.scale},
          {"u_scale_ppm", 1e6 * plate.u_scale},
          {"en_worst", plate.en_worst},
          {"not_measured", plate.not_measured},
          {"finding", text_or_null(plate.finding)},
          {"balls", balls}};
}

Json calibration_json(const PlateCalibration& calibration) {
  Json balls = Json::array();
  for (Eigen::Index i = 0; i < calibration.centres.cols(); ++i) {
    const auto at = calibration.centres.col(i);
    const auto off = calibration.deviations.col(i);
    balls.push_back({{"feature", calibration.features[i]},
                     {"at_mm", {at.x(), at.y(), at.z()}},
                     {"deviation_mm", {off.x(), off.y(), off.z()}},
                     {"u_mm", calibration.u(i)}});
  }
  return {{"artefact", calibration.artefact},
          {"placements", calibration.placements},
          {"least_turn_rad", calibration.least_turn},
          {"balls", balls}};
}

Json articulation_json(const Articulation& articulation) {
  const auto& half = articulation.half_range;
  return {{"artefact", articulation.artefact},
          {"placement", articulation.placement},
          {"feature", articulation.feature},
          {"readings", articulation.readings},
          {"largest_mm", articulation.largest},
          {"twice_s_mm", articulation.twice_s},
          {"half_range_mm", {half.x(), half.y(), half.z()}}};
}

Json volumetric_json(const VolumetricSummary& summary) {
  return {{"lengths", summary.lengths},
          {"largest_mm", summary.largest},
          {"range_mm", summary.range},
          {"twice_rms_mm", summary.twice_rms},
          {"twice_s_mm", summary.twice_s}};
}

Json interim_json(const InterimCheck& check) {
  Json drifts = Json::array();
  for (const Drift& drift : check.drifts) {
    drifts.push_back({{"quantity", artcal::name_of(drift.quantity)},
                      {"artefact", drift.artefact},
                      {"placement", drift.placement},
                      {"first", drift.first},
                      {"second", text_or_null(drift.second)},
                      {"repeats_then", drift.repeats_then},
                      {"repeats_now", drift.repeats_now},
                      {"then_mm", drift.then},
                      {"now_mm", drift.now},
                      {"drift_mm", drift.drift},
                      {"u_mm", drift.u},
                      {"repeatability_mm", drift.repeatability},
                      {"degrees_of_freedom", drift.degrees_of_freedom},
                      {"effective_degrees_of_freedom", number_or_null(drift.effective_degrees_of_freedom)},
                      {"coverage", drift.coverage},
                      {"significant", drift.significant}});
  }
  return {{"drifts", drifts}, {"not_compared", check.not_compared}};
}

}  // namespace

Json to_json(const Session& session, const VerificationResult& result) {
  const Verification& verification = result.verification;
  Json json = result_header(session.recording, "verification", std::nullopt);
  json["arm"] = session.arm.name;
  json["date"] = text_or_null(session.recording.date);
  json["temperature"] = temperature_json(session.recording);
  json["artefacts"] = artefacts_json(session.constraints.artefacts);
  json["readings"] = session.recording.readings.size();
  json["standard"] = verification.standard;
  json["tip_centres"] = session.tips.source == TipSource::Reported ? "reported" : "joints";
  json["specification"] = text_or_null(session.specification.name);
  json["decision_rule"] = text_of(verification.rule);
  json["conclusion"] = result_name(verification.conclusion);
  json["values"] = json_list(verification.values, value_json);
  json["plates"] = json_list(result.plates, plate_json);
  json["plate_calibrations"] = json_list(result.calibrations, calibration_json);
  json["articulations"] = json_list(result.articulations, articulation_json);
  json["volumetric"] = result.volumetric ? volumetric_json(*result.volumetric) : Json(nullptr);
  json["interim"] = result.interim ? interim_json(*result.interim) : Json(nullptr);
  json["missing"] = verification.missing;
  json["waived"] = verification.waived;
  json["warnings"] = verification.warnings;
  json["features"] = feature_places_json(session);
  json["arm_shape"] = arm_shape_json(session.recording, session.arm);
  return json;
}

}  // namespace artcal
