#pragma once

#include "identification/least_squares/problem.h"
#include "identification/problem/system.h"

namespace artcal {

/// Options for the first solution where poses lie nearly on a line: along turns that readings hardly see, steps are
/// small against the way. Elsewhere these options.
SolveOptions patient_options(const Constraints& constraints, const SolveOptions& options);

/// Corrects a solution from `x_start` with patient_options() where poses lie nearly on a line, whose turn about it is
/// seen only faintly: wrong turns are minima too, and an arm that is still off makes them look right. The arm is then
/// solved for a second time, from the turns that a solution with scaled turns gives (PoseTurn::Scaled), in which the
/// residuals are linear. In both solutions turns are taken where their arm has them, and it is solved again while that
/// lowers the cost. The lower cost wins. Elsewhere the solution stays as it is.
Solution with_corrected_turns(Solution solution, const System& system, const Recording& recording,
                              const Weights& weights, const Eigen::VectorXd& x_start, const SolveOptions& options);

}  // namespace artcal
