#pragma once

#include "artefacts/constraint.h"
#include "core/error.h"
#include "identification/selection.h"

namespace artcal {

/// The arm to linearise at and to begin with: `nominal`, but with the tips stated as lx, ly, lz (known
/// roughly, found by calibration) moved to where the readings have them, all else held. A tip exactly on
/// the last axis is a special place at which more is lost than anywhere near it, so that the rank there
/// would say less than the readings can tell. Tips that the readings do not show well are left alone.
Expected<Arm> arm_with_fitted_tips(const Recording& recording, const Constraints& constraints, const Arm& nominal,
                                   const std::vector<std::string>& held);

/// The same arm, or where it is further off than the balls are large, one that is near enough: identified
/// with each ball taken for a point. From an arm that misses by more than a ball's radius the readings do
/// not show on which side of them the ball is, and a fit to its surface would end anywhere.
/// What `selection` holds stays held, and so does what the points alone cannot tell.
Expected<Arm> arm_near_the_balls(const Recording& recording, const Constraints& constraints, const Arm& start,
                                 const Selection& selection);

}  // namespace artcal
