#pragma once

#include <nlohmann/json.hpp>

#include "app/report/sheet.h"

namespace artcal {

/// What an identification came to, for the top of a report.
void write_identification_verdict(const nlohmann::ordered_json& result, Sheet& sheet);

/// An identification: before and after, parameters, what could not be determined, pictures.
/// Throws std::exception where the JSON is not as docs/result-schema.md says.
void write_identification(const nlohmann::ordered_json& result, Sheet& sheet);

}  // namespace artcal
