#pragma once

#include "identification/problem/system.h"

namespace artcal {

/// Moves readings, by small changes of their joints, to where their constraints want the tip: onto their unknown
/// point, onto their unknown plane, or onto their ball.
///
/// Why: what is unidentifiable is unidentifiable for the cost, not for each residual vector. Turning the base turns the
/// residuals of readings that do not meet in their common point, and letting all lengths grow lets the residuals of any
/// reading without a certified length grow; at the nominal arm, some mm off, that makes unidentifiable parameters look
/// determined. With the readings on their constraints the rank is what it is for a perfect arm.
/// Readings of unknown points, of planes and of balls of unknown radius need it; those of certified coordinates,
/// lengths and radii do not.
///
/// REQUIRES: `unknowns` satisfy the distances. Changes System::sines and joints; returns how many readings could not
/// be moved (an arm stretched out, say), whose constraints are left as they are.
int project_onto_constraints(System& system, const Recording& recording, const Arm& arm, const Unknowns& unknowns);

/// Whether project_onto_constraints() moves the readings of this feature.
bool needs_moving(const FeatureConstraint& feature, const Constraints& constraints);

}  // namespace artcal
