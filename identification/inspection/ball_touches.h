#pragma once

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/evaluation/evaluation.h"
#include "identification/inspection/finding.h"

namespace artcal {

/// Standard deviation of a ball's centre in its worst direction above which its touches do not determine it, per
/// standard deviation of one touch.
inline constexpr double max_centre_dilution = 4.0;

/// Balls whose centre is unknown and whose touches do not determine it: on one circle, where the centre has a mirror
/// image, or on so small a part of the ball that the dilution is above max_centre_dilution. `nominal` is the evaluation
/// of the arm that the directions of the touches come from. Balls of a certified pattern are passed over: the pattern
/// has a pose, and they need no centre of their own.
Findings find_undetermined_centres(const Recording& recording, const Constraints& constraints,
                                   const Evaluation& nominal);

}  // namespace artcal
