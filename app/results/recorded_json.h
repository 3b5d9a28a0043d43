#pragma once

#include <limits>
#include <string>

#include <nlohmann/json.hpp>

namespace artcal {

/// NaN for null, which is how JSON holds what is not a number. Throws std::exception for what is something else.
inline double recorded_number(const nlohmann::ordered_json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

/// Empty for null and for what is absent. Throws as that.
inline std::string recorded_text(const nlohmann::ordered_json& json, const char* key) {
  return json.contains(key) && !json.at(key).is_null() ? json.at(key).get<std::string>() : std::string();
}

}  // namespace artcal
