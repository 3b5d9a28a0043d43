#pragma once

#include "app/report/sheet.h"
#include "app/results/identification/recorded/recorded_identification.h"
#include "app/results/verification/recorded_verification.h"

namespace artcal {

/// The arm, the artefacts in their placements and the errors of the readings as enlarged vectors, in space.
/// REQUIRES: the identification has its readings.
Figure scene_of(const RecordedIdentification& identification);

/// The arm and the places where a verification measured.
Figure scene_of_verification(const RecordedVerification& verification);

}  // namespace artcal
