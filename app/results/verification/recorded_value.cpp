#include "app/results/verification/recorded_value.h"

#include <cmath>

#include <fmt/format.h>

#include "app/results/result_names.h"
#include "artefacts/verification/decision/specification.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

Budget recorded_budget(const RecordedObject& json) {
  return {json.number("calibration_mm"),
          json.number("expansion_mm"),
          json.number("temperature_mm"),
          json.number("alignment_mm"),
          json.number("fixture_mm"),
          json.number("form_mm"),
          json.optional_number("points_mm").value_or(0.0)};
}

Place recorded_place(const RecordedObject& json) {
  Place place;
  place.point_in_base = json.point("point_mm");
  place.octant = json.integer("octant");
  place.share_of_reach = json.number("share_of_reach");
  place.above_base = json.truth("above_base");
  place.joint_at_stop = json.has("joint_at_stop") ? json.integer("joint_at_stop") : 0;
  return place;
}

Quantity known_quantity(const RecordedObject& json) {
  const std::string name = json.text("quantity");
  const auto named = quantity_named(name);
  if (!named) {
    json.refuse("quantity", fmt::format("{}, expected {}; was the file made by a later version?", in_quotes(name),
                                        quantity_names()));
  }
  return *named;
}

// Numbers that results of earlier versions do not have are absent; null is how JSON holds what is not a number.
RecordedValue recorded_value(const RecordedObject& json) {
  RecordedValue value;
  value.quantity = name_of(known_quantity(json));
  value.artefact = json.text_or("artefact");
  value.placement = json.text_or("placement");
  value.first = json.text_or("first");
  value.second = json.text_or("second");
  value.repeat = json.text_or("repeat");
  value.certified = json.optional_number("certified_mm");
  value.stated = json.optional_number("stated_mm").value_or(RecordedValue::not_there);
  value.stated_at = json.optional_number("stated_at_C").value_or(RecordedValue::not_there);
  value.value = json.number("value_mm");
  value.temperature = json.optional_number("temperature_C").value_or(RecordedValue::not_there);
  value.limit = json.optional_number("limit_mm");
  value.u = json.number("u_mm");
  value.budget = json.has("budget") ? std::optional(recorded_budget(json.object("budget"))) : std::nullopt;
  value.verdict = verdict_named(json.text("verdict"));
  value.set_aside = json.truth("set_aside");
  value.place = recorded_place(json.object("place"));
  return value;
}

Drift recorded_drift(const RecordedObject& json) {
  Drift drift;
  drift.quantity = known_quantity(json);
  drift.placement = json.text_or("placement");
  drift.first = json.text_or("first");
  drift.second = json.text_or("second");
  drift.then = json.number("then_mm");
  drift.now = json.number("now_mm");
  drift.drift = json.number("drift_mm");
  drift.u = json.optional_number("u_mm").value_or(RecordedValue::not_there);
  drift.degrees_of_freedom = json.integer("degrees_of_freedom");
  drift.significant = json.truth("significant");
  return drift;
}

}  // namespace

double RecordedValue::severity() const { return limit ? std::abs(value) / *limit : std::abs(value); }

std::vector<RecordedValue> recorded_values(const RecordedObject& verification) {
  return verification.list("values", recorded_value);
}

std::optional<std::vector<Drift>> recorded_drifts(const RecordedObject& verification) {
  return verification.has("interim") ? std::optional(verification.object("interim").list("drifts", recorded_drift))
                                     : std::nullopt;
}

}  // namespace artcal
