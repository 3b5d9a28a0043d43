#pragma once

#include "artefacts/constraint.h"
#include "identification/selection.h"

namespace artcal {

/// `start`, or where it is too far off for the balls to be seen, an arm that is near enough. From an arm that
/// misses by a good part of a ball's radius, readings on half a ball fit one on the wrong side of them as
/// well, and one such ball spoils the fit of all. So where readings of a ball are not round (3 % of its radius), the
/// arm is fitted with a loss that lets go of balls far off, these are settled anew, and so on with a loss that
/// narrows from 3 mm to 0.3 mm until all are round: from the arm itself and, where that does not end so, from the
/// arm identified with each ball taken for a point. Where neither does, the arm that sees the most balls.
/// What `selection` holds stays held, and so does what the points alone cannot tell.
Arm arm_near_the_balls(const Recording& recording, const Constraints& constraints, const Arm& start,
                       const Selection& selection);

}  // namespace artcal
