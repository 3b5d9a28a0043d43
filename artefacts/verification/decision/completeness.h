#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// Adds to `missing` what the plan asks of the ball's tests and is not there: positions of the ball, points
/// in each, orientations of the wrist and points in each of them.
void check_sphere_plan(const Session& session, Verification& verification);

/// Adds to `missing` what the plan asks of the lengths and is not there: positions, lengths in each, repeats
/// of each, the share of the measuring range that the longest must reach, and named positions and lengths.
void check_length_plan(const Session& session, Verification& verification);

}  // namespace artcal
