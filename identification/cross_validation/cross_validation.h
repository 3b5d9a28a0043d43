#pragma once

#include <vector>

#include "identification/cross_validation/leave_out.h"
#include "identification/estimation.h"

namespace artcal {

/// Identifies once more without each placement and evaluates that placement with the arm found: by a few steps from
/// the estimate (PlacementRefit) where they lead to the same arm, else by a whole fit that begins at the estimate.
/// `system` is make_system() at the arm of the estimate; `scale_factor` that of its uncertainty.
std::vector<LeftOut> evaluate_left_out(const System& system, const Estimate& estimate, const Recording& recording,
                                       const IdentifyOptions& options, double scale_factor);

}  // namespace artcal
