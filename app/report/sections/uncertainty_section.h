#pragma once

#include <nlohmann/json.hpp>

#include "app/report/sheet.h"

namespace artcal {

/// What the identified arm measures like: lengths, a sphere, and a map over the working volume.
/// Throws std::exception where the JSON is not as docs/result-schema.md says ("uncertainty_result").
void write_uncertainty(const nlohmann::ordered_json& result, Sheet& sheet);

}  // namespace artcal
