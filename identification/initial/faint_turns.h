#pragma once

#include "identification/least_squares/problem.h"
#include "identification/problem/system.h"

namespace artcal {

/// solve() where poses may lie nearly on a line, whose turn about it is seen only faintly: wrong turns are minima too,
/// and an arm that is still off makes them look right. If there are such poses, the arm is solved for twice, from
/// `start` and from the turns that a solution with scaled turns gives (PoseTurn::Scaled), in which the residuals are
/// linear. Each time turns are taken where the solution's arm has them, and it is solved again while that lowers the
/// cost. The lower cost wins. Elsewhere it is solve().
Solution solve_with_turns(const System& system, const Recording& recording, const Weights& weights,
                          const Eigen::VectorXd& x_start, const Unknowns& start, const SolveOptions& options);

}  // namespace artcal
