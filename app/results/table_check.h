#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace artcal {

/// Reads a part (result_table.h) of an identification or a verification by its typed reader. Refused: a table that is
/// not as docs/result-schema.md says, with the place and the reason. Tables of other results are not looked at.
Expected<void> check_table(const nlohmann::ordered_json& result, std::string_view part);

}  // namespace artcal
