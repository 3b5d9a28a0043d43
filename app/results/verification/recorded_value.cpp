#include "app/results/verification/recorded_value.h"

#include <cmath>

#include "app/results/result_names.h"
#include "artefacts/verification/decision/specification.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

// Absent, in results of earlier versions, or null, which is how JSON holds what is not a number.
double number_or(const Json& json, const char* key, double otherwise) {
  return json.contains(key) && !json.at(key).is_null() ? json.at(key).get<double>() : otherwise;
}

std::optional<double> optional_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

std::string text_or_nothing(const Json& json) { return json.is_null() ? std::string() : json.get<std::string>(); }

Budget budget_from(const Json& json) {
  return {json.at("calibration_mm"), json.at("expansion_mm"), json.at("temperature_mm"),        json.at("alignment_mm"),
          json.at("fixture_mm"),     json.at("form_mm"),      number_or(json, "points_mm", 0.0)};
}

Place place_from(const Json& json) {
  Place place;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    place.point_in_base[axis] = json.at("point_mm").at(static_cast<std::size_t>(axis));
  }
  place.octant = json.at("octant");
  place.share_of_reach = json.at("share_of_reach");
  place.above_base = json.at("above_base");
  place.joint_at_stop = json.at("joint_at_stop").is_null() ? 0 : json.at("joint_at_stop").get<int>();
  return place;
}

RecordedValue value_from(const Json& json) {
  RecordedValue value;
  value.quantity = json.at("quantity");
  value.artefact = text_or_nothing(json.at("artefact"));
  value.placement = text_or_nothing(json.at("placement"));
  value.first = text_or_nothing(json.at("first"));
  value.second = text_or_nothing(json.at("second"));
  value.repeat = text_or_nothing(json.at("repeat"));
  value.certified = optional_number(json.at("certified_mm"));
  value.stated = number_or(json, "stated_mm", RecordedValue::not_there);
  value.stated_at = number_or(json, "stated_at_C", RecordedValue::not_there);
  value.value = json.at("value_mm");
  value.temperature = number_or(json, "temperature_C", RecordedValue::not_there);
  value.limit = optional_number(json.at("limit_mm"));
  value.u = json.at("u_mm");
  value.budget = json.contains("budget") ? std::optional(budget_from(json.at("budget"))) : std::nullopt;
  value.verdict = verdict_named(json.at("verdict").get<std::string>());
  value.set_aside = json.at("set_aside");
  value.place = place_from(json.at("place"));
  return value;
}

Drift drift_from(const Json& json) {
  Drift drift;
  drift.quantity = quantity_named(json.at("quantity").get<std::string>()).value();
  drift.placement = text_or_nothing(json.at("placement"));
  drift.first = text_or_nothing(json.at("first"));
  drift.second = text_or_nothing(json.at("second"));
  drift.then = json.at("then_mm");
  drift.now = json.at("now_mm");
  drift.drift = json.at("drift_mm");
  drift.u = number_or(json, "u_mm", RecordedValue::not_there);
  drift.degrees_of_freedom = json.at("degrees_of_freedom");
  drift.significant = json.at("significant");
  return drift;
}

}  // namespace

double RecordedValue::severity() const { return limit ? std::abs(value) / *limit : std::abs(value); }

std::vector<RecordedValue> recorded_values(const Json& verification) {
  std::vector<RecordedValue> values;
  for (const Json& json : verification.at("values")) {
    values.push_back(value_from(json));
  }
  return values;
}

std::vector<Drift> recorded_drifts(const Json& interim) {
  std::vector<Drift> drifts;
  for (const Json& json : interim.at("drifts")) {
    drifts.push_back(drift_from(json));
  }
  return drifts;
}

}  // namespace artcal
