#pragma once

#include <nlohmann/json.hpp>

#include "app/report/sheet.h"

namespace artcal {

/// What a verification came to, for the top of a report.
void write_verification_verdict(const nlohmann::ordered_json& result, Sheet& sheet);

/// A verification: what is missing, every value with limit, uncertainty and verdict, what its standard tells beside.
/// Throws std::exception where the JSON is not as docs/result-schema.md says.
void write_verification(const nlohmann::ordered_json& result, Sheet& sheet);

}  // namespace artcal
