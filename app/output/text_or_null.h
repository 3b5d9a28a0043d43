#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace artcal {

/// A text as JSON; null where it is empty, which says that there is none.
inline nlohmann::ordered_json text_or_null(const std::string& text) {
  return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

}  // namespace artcal
