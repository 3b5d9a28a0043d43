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

/// The same arm, or where it is too far off for the balls to be seen, one that is near enough. From an arm that
/// misses by a good part of a ball's radius, readings on half a ball fit one on the wrong side of them as
/// well, and one such ball spoils the fit of all. So where the readings are not round (3 % of the radius), the
/// arm is fitted with a loss that lets go of balls far off, these are settled anew, and so on until all are
/// round; from the arm itself or, where that does not end so, from the arm identified with each ball taken for
/// a point. What `selection` holds stays held, and so does what the points alone cannot tell.
Arm arm_near_the_balls(const Recording& recording, const Constraints& constraints, const Arm& start,
                       const Selection& selection);

}  // namespace artcal
