#pragma once

#include "acquisition/recording/recording.h"
#include "identification/inspection/finding.h"

namespace artcal {

/// Readings that agree with an earlier one in all joint angles to a microradian, although not to the last digit or not
/// on the same feature: a table that overlaps with another, written with other decimals, or rows under two names. Two
/// independent touches of an arm do not agree so. One finding for all of them. Readings equal in every number on one
/// feature are no longer in a recording that was bound to its artefacts
/// (artefacts/constraints/coincident_readings.h).
Findings find_repeated_postures(const Recording& recording);

}  // namespace artcal
