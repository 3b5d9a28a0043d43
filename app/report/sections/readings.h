#pragma once

#include "app/report/sheet.h"
#include "app/results/identification/recorded/recorded_identification.h"

namespace artcal {

/// What each reading deviates by, in the order of the placements. REQUIRES: the identification has its readings.
Figure residuals_by_placement(const RecordedIdentification& identification);

/// The same against the angle of each joint: a wave shows an eccentric encoder.
Figure residuals_by_joint(const RecordedReadings& readings);

}  // namespace artcal
