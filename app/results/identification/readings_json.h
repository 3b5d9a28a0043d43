#pragma once

#include <nlohmann/json.hpp>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/identify.h"

namespace artcal {

/// Every reading by itself, column by column: its joint angles, where the identified arm has the tip, what it
/// deviates by. Schema: docs/result-schema.md, "residuals".
nlohmann::ordered_json residuals_json(const Recording& recording, const Constraints& constraints,
                                      const Identification& result);

/// The arm as a line through its joints in the posture of the reading in the middle of the recording; null where
/// no reading has joint angles. Schema: docs/result-schema.md, "arm_shape".
nlohmann::ordered_json arm_shape_json(const Recording& recording, const Arm& arm);

/// Lowest and highest temperature of an artefact that was read; null where none was.
nlohmann::ordered_json temperature_json(const Recording& recording);

}  // namespace artcal
