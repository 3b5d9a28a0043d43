#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace artcal {

/// Values of a JSON text may be nested this deep; results of artcal use less than ten levels.
inline constexpr std::size_t max_json_depth = 64;

/// Parses a JSON text that anybody may have written, in time and memory proportional to its length. Members keep their
/// order. Refused, as no `what` ("result of artcal"): what is not valid JSON, values nested deeper than max_json_depth,
/// a key twice in one object. `path` is for the message.
Expected<nlohmann::ordered_json> parse_json(std::string_view text, std::string_view what, const std::string& path);

}  // namespace artcal
