#include <map>

#include "app/history/history_text.h"
#include "app/history/over_time.h"
#include "app/output/text_or_null.h"
#include "app/results/result_head.h"
#include "app/results/result_names.h"
#include "core/statistics.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json entry_json(const HistoryEntry& entry) {
  return {{"recording", entry.recording},
          {"date", text_or_null(entry.date)},
          {"name", entry.name},
          {"certificates", entry.certificates}};
}

Json change_json(const ParameterChange& change) {
  return {{"name", change.name},
          {"unit", change.unit},
          {"then", change.then},
          {"now", change.now},
          {"u", change.u},
          {"limit", change.limit},
          {"significant", change.significant}};
}

Json drift_json(const Drift& drift) {
  return {{"quantity", name_of(drift.quantity)},
          {"artefact", drift.artefact},
          {"placement", drift.placement},
          {"first", drift.first},
          {"second", text_or_null(drift.second)},
          {"then_mm", drift.then},
          {"now_mm", drift.now},
          {"u_mm", drift.u},
          {"significant", drift.significant}};
}

Json step_json(const ArmHistory& history, const CalibrationStep& step) {
  Json json{
      {"then", history.calibrations[step.then].entry.recording},
      {"now", history.calibrations[step.now].entry.recording},
      {"not_comparable", text_or_null(step.not_comparable)},
      {"moved", step.moved},
      {"chi_squared", step.chi_squared},
      {"chi_squared_95", step.limit},
      {"significant", step.significant()},
      {"certificates_in_common", step.in_common},
      {"change_of_lengths",
       step.lengths ? Json{{"rms_mm", step.lengths->rms}, {"maximum_mm", step.lengths->maximum}} : Json(nullptr)}};
  json["changes"] = Json::array();
  for (const ParameterChange& change : step.changes) {
    json["changes"].push_back(change_json(change));
  }
  return json;
}

Json step_json(const ArmHistory& history, const VerificationStep& step) {
  Json json{{"then", history.verifications[step.then].entry.recording},
            {"now", history.verifications[step.now].entry.recording},
            {"certificates_in_common", step.in_common}};
  json["drifts"] = Json::array();
  for (const Drift& drift : step.check.drifts) {
    json["drifts"].push_back(drift_json(drift));
  }
  return json;
}

Json parameters_over_time(const ArmHistory& history) {
  std::vector<std::string> names;
  std::map<std::string, Json> parameters;
  for (const Calibration& calibration : history.calibrations) {
    for (const CalibratedParameter& parameter : calibration.parameters) {
      auto [at, is_new] = parameters.try_emplace(
          parameter.name, Json{{"name", parameter.name}, {"unit", parameter.unit}, {"points", Json::array()}});
      if (is_new) {
        names.push_back(parameter.name);
      }
      at->second["points"].push_back({{"recording", calibration.entry.recording},
                                      {"date", text_or_null(calibration.entry.date)},
                                      {"state", parameter.state},
                                      {"value", parameter.value},
                                      {"u", parameter.u > 0.0 ? Json(parameter.u) : Json(nullptr)}});
    }
  }
  Json all = Json::array();
  for (const std::string& name : names) {
    all.push_back(std::move(parameters[name]));
  }
  return all;
}

Json value_json(const ArmHistory& history, const ValueOverTime& value) {
  Json points = Json::array();
  for (const ValueThen& point : value.points) {
    const HistoryEntry& entry = history.verifications[point.verification].entry;
    points.push_back({{"recording", entry.recording},
                      {"date", text_or_null(entry.date)},
                      {"repeats", point.repeats},
                      {"mean_mm", point.value},
                      {"u_mm", point.u},
                      {"coverage_factor", point.coverage_factor},
                      {"limit_mm", point.limit ? Json(*point.limit) : Json(nullptr)}});
  }
  return {{"standard", value.standard}, {"quantity", name_of(value.quantity)},
          {"artefact", value.artefact}, {"placement", value.placement},
          {"first", value.first},       {"second", text_or_null(value.second)},
          {"points", std::move(points)}};
}

Json worst_json(const ArmHistory& history, const WorstOverTime& worst) {
  Json points = Json::array();
  for (const auto& [verification, value] : worst.points) {
    const HistoryEntry& entry = history.verifications[verification].entry;
    points.push_back({{"recording", entry.recording},
                      {"date", text_or_null(entry.date)},
                      {"artefact", value->artefact},
                      {"placement", value->placement},
                      {"first", value->first},
                      {"second", text_or_null(value->second)},
                      {"value_mm", value->value},
                      {"u_mm", value->budget.total()},
                      {"coverage_factor", stated_coverage_factor(value->budget.degrees_of_freedom())},
                      {"limit_mm", value->limit ? Json(*value->limit) : Json(nullptr)},
                      {"verdict", result_name(value->verdict)}});
  }
  return {{"standard", worst.standard}, {"quantity", name_of(worst.quantity)}, {"points", std::move(points)}};
}

}  // namespace

Json to_json(const ArmHistory& history) {
  Json json = result_head("history");
  json["arm"] = history.arm;
  for (const char* list : {"calibrations", "verifications", "parameter_steps", "value_steps", "values_overall",
                           "values_over_time", "worst_over_time"}) {
    json[list] = Json::array();
  }
  for (const Calibration& calibration : history.calibrations) {
    Json entry = entry_json(calibration.entry);
    entry["rms_before_mm"] = calibration.rms_before ? Json(*calibration.rms_before) : Json(nullptr);
    entry["rms_after_mm"] = calibration.rms_after;
    json["calibrations"].push_back(std::move(entry));
  }
  for (const PastVerification& verification : history.verifications) {
    Json entry = entry_json(verification.entry);
    entry["standard"] = verification.standard;
    entry["conclusion"] = result_name(verification.conclusion);
    json["verifications"].push_back(std::move(entry));
  }
  for (const CalibrationStep& step : history.calibration_steps) {
    json["parameter_steps"].push_back(step_json(history, step));
  }
  for (const VerificationStep& step : history.verification_steps) {
    json["value_steps"].push_back(step_json(history, step));
  }
  json["parameters_overall"] =
      history.calibrations_overall ? step_json(history, *history.calibrations_overall) : Json(nullptr);
  for (const VerificationStep& step : history.verifications_overall) {
    json["values_overall"].push_back(step_json(history, step));
  }
  json["parameters_over_time"] = parameters_over_time(history);
  for (const ValueOverTime& value : values_over_time(history)) {
    json["values_over_time"].push_back(value_json(history, value));
  }
  for (const WorstOverTime& worst : worst_over_time(history)) {
    json["worst_over_time"].push_back(worst_json(history, worst));
  }
  return json;
}

}  // namespace artcal
