#pragma once

#include <nlohmann/json.hpp>

#include "app/report/sections/readings.h"
#include "app/report/sheet.h"

namespace artcal {

/// The arm, the artefacts in their placements and the errors of the readings as enlarged vectors, in space.
/// Throws std::exception where the JSON is not as docs/result-schema.md says.
Figure scene_of(const nlohmann::ordered_json& identification, const ReportedReadings& readings);

/// The arm and the places where a verification measured. Throws as above.
Figure scene_of_verification(const nlohmann::ordered_json& verification);

}  // namespace artcal
