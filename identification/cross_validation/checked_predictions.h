#pragma once

#include <vector>

#include "identification/evaluation/evaluation.h"
#include "identification/identify.h"
#include "identification/uncertainty/uncertain_arm.h"

namespace artcal {

/// Predictions that an arm makes of a placement it was identified without, each with its uncertainty (first order,
/// JCGM 100 §5.2): certified lengths; distances between the certified places of a plate; coordinates that are known in
/// the base frame. `evaluation` is of `placement` (constraints of that placement alone) with the arm of `sources`, the
/// covariance that of the identification without it.
std::vector<CheckedPrediction> check_predictions(const Recording& recording, const Constraints& placement,
                                                 const Evaluation& evaluation, const Arm& arm,
                                                 const UncertaintySources& sources);

}  // namespace artcal
