#pragma once

#include "identification/system.h"

namespace artcal {

/// Moves readings, by the smallest change of their joints, to where their constraints want the tip.
///
/// Why: a lost frame is lost for the cost, not for each residual vector. Turning the base turns the
/// residuals of readings that do not meet in their common point, and at the nominal arm, some mm off, that
/// makes a lost parameter look determined. With the readings on their points the rank is what it is for a
/// perfect arm. Only readings of unknown points need it: other residuals do not see the base move.
///
/// REQUIRES: `unknowns` satisfy the distances. Changes System::sines; returns how many readings could not
/// be moved (an arm stretched out, say), whose constraints are left as they are.
int make_consistent(System& system, const Recording& recording, const Arm& arm, const Unknowns& unknowns);

}  // namespace artcal
