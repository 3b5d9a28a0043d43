#pragma once

#include <vector>

#include "app/report/sheet.h"
#include "app/results/verification/recorded_verification.h"

namespace artcal {

/// What a verification tells beside its values: plates and their balls, plates calibrated by turning them, seats and
/// the volumetric summary of ASME B89.4.22, drifts since an earlier verification. Where there is none of it, nothing.
void write_beside_values(const RecordedVerification& verification, Sheet& sheet);

/// Whether the arm drifted, in words.
void write_interim_verdict(const std::vector<Drift>& drifts, Sheet& sheet);

}  // namespace artcal
