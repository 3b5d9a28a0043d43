#include "app/results/schema_version.h"

#include <string>
#include <utility>

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

// The member of an object; null where there is none.
Json& member(Json& json, const char* key) {
  static thread_local Json none;
  none = nullptr;
  return json.is_object() && json.contains(key) ? json[key] : none;
}

// In place, so that the order of the keys stays.
void rename_key(Json& json, const char* from, const char* to) {
  if (!json.is_object() || !json.contains(from)) {
    return;
  }
  Json renamed = Json::object();
  for (auto& [key, value] : json.items()) {
    renamed[key == from ? to : key] = std::move(value);
  }
  json = std::move(renamed);
}

void rename_text(Json& json, const char* key, const char* from, const char* to) {
  if (Json& value = member(json, key); value == from) {
    value = to;
  }
}

void rename_coupling(Json& coupling) {
  rename_key(coupling, "lost", "unidentifiable");
  rename_text(coupling, "scale", "lost", "unidentifiable");
  for (Json& direction : member(coupling, "unidentifiable")) {
    rename_key(direction, "held", "fixed");
    rename_key(direction, "unseen_motion", "motion");
  }
}

// Schema 1 was released with other words for fixed and unidentifiable parameters and for the scale factor.
void from_first_schema(Json& result) {
  rename_coupling(member(result, "coupling"));
  for (Json& parameter : member(result, "parameters")) {
    rename_text(parameter, "state", "held", "fixed");
    rename_text(parameter, "state", "lost", "unidentifiable");
  }
  rename_key(member(result, "noise"), "enlargement", "scale_factor");
  rename_key(result, "enlargement", "scale_factor");
  for (Json& finding : member(member(result, "model_study"), "findings")) {
    rename_text(finding, "effect", "warmth", "temperature_offset");
  }
  for (Json& quantity : member(result, "quantities")) {
    rename_key(quantity, "stands", "stable");
  }
}

}  // namespace

bool bring_up_to_date(Json& result) {
  const Json& version = member(result, "schema_version");
  if (version == schema_version) {
    return true;
  }
  if (version != 1) {
    return false;
  }
  from_first_schema(result);
  result["schema_version"] = schema_version;
  return true;
}

}  // namespace artcal
