#include "app/history/history_text.h"
#include "app/result_head.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json entry_json(const HistoryEntry& entry) {
  return {{"recording", entry.recording},
          {"date", text_or_null(entry.date)},
          {"name", entry.name},
          {"certificates", entry.certificates}};
}

Json change_json(const ParameterChange& change) {
  return {{"name", change.name}, {"unit", change.unit}, {"then", change.then},
          {"now", change.now},   {"u", change.u},       {"significant", change.significant}};
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
  Json json{{"then", history.calibrations[step.then].entry.recording},
            {"now", history.calibrations[step.now].entry.recording},
            {"not_comparable", text_or_null(step.not_comparable)},
            {"chi_squared", step.chi_squared},
            {"chi_squared_95", step.limit},
            {"significant", step.significant()},
            {"certificates_in_common", step.in_common}};
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

}  // namespace

Json to_json(const ArmHistory& history) {
  Json json = result_head("history");
  json["arm"] = history.arm;
  for (const char* list : {"calibrations", "verifications", "parameter_steps", "value_steps"}) {
    json[list] = Json::array();
  }
  for (const Calibration& calibration : history.calibrations) {
    Json entry = entry_json(calibration.entry);
    entry["rms_before_mm"] = calibration.rms_before;
    entry["rms_after_mm"] = calibration.rms_after;
    json["calibrations"].push_back(std::move(entry));
  }
  for (const PastVerification& verification : history.verifications) {
    Json entry = entry_json(verification.entry);
    entry["standard"] = verification.standard;
    entry["conclusion"] = verification.conclusion;
    json["verifications"].push_back(std::move(entry));
  }
  for (const CalibrationStep& step : history.calibration_steps) {
    json["parameter_steps"].push_back(step_json(history, step));
  }
  for (const VerificationStep& step : history.verification_steps) {
    json["value_steps"].push_back(step_json(history, step));
  }
  return json;
}

}  // namespace artcal
