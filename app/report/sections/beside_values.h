#pragma once

#include <nlohmann/json.hpp>

#include "app/report/sheet.h"

namespace artcal {

/// What a verification tells beside its values: plates and their balls, plates calibrated by turning them, seats and
/// the volumetric summary of ASME B89.4.22, drifts since an earlier verification. Where there is none of it, nothing.
/// Throws std::exception where the JSON is not as docs/result-schema.md says.
void write_beside_values(const nlohmann::ordered_json& verification, Sheet& sheet);

/// Whether the arm drifted, in words.
void write_interim_verdict(const nlohmann::ordered_json& interim, Sheet& sheet);

}  // namespace artcal
