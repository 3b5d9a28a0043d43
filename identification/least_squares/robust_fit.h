#pragma once

#include "identification/least_squares/arm_fit.h"

namespace artcal {

/// Continues the least-squares fit `fit` of `system` at `x` with the robust loss of `options`, by iterated reweighting:
/// weighted least squares, then anew the noise where it is not given (median_noise_factor()), the variances by which
/// the loss measures each observation (Redundancy), and its weights, until these converge. Huber's loss, whose minimum
/// is unique near a linear model, leads the way for some rounds, so that Cauchy's begins near the readings that most
/// agree on. No solution: no convergence.
Expected<ArmFit> robust_fit(const System& system, const Noise& noise, const SolveOptions& options, Eigen::VectorXd x,
                            ArmFit fit);

}  // namespace artcal
