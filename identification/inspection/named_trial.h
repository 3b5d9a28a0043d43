#pragma once

#include <vector>

#include "identification/inspection/as_written.h"
#include "identification/inspection/finding.h"
#include "identification/inspection/trial_fit.h"

namespace artcal {

/// Of the trials that explain the readings equally well (residuals within half of the least), the one that adds least;
/// null where there is none.
const Trial* simplest_of(const std::vector<Trial>& accepted);

/// What a trial says of the recording: the mistake, what the deviations are without it, what to do.
Finding finding_of(const Trial& trial, const AsWritten& as_written);

/// Puts the radii that were found for the tips into the hypothesis' words, beside those that `stated` has.
void describe_radii(Trial& trial, const Arm& stated);

}  // namespace artcal
