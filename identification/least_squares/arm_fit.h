#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "identification/least_squares/problem.h"
#include "identification/problem/system.h"
#include "identification/uncertainty/covariance.h"
#include "identification/uncertainty/redundancy.h"

namespace artcal {

/// One least-squares identification with its noise determined.
struct ArmFit {
  Arm arm;
  Unknowns unknowns;
  Weights weights;              ///< in force at the end
  WhitenedResiduals residuals;  ///< under these
  LossWeights loss_weights;     ///< how much of each observation counts; all 1 without a loss
  Weights counted;              ///< the weights as the observations count (counted_weights()); without a loss the same
  Linearisation linearisation;  ///< at the solution, under `counted`; columns are the free parameters
  Eigen::VectorXd scale;        ///< of its columns, System::scale
  double noise = 0.0;           ///< mm a coordinate; the median over postures where it depends on them
  int degrees_of_freedom = 0;
  int iterations = 0;
  int rounds = 0;  ///< solves, each with better weights
  double cost = 0.0;
  std::string termination;
};

/// A weak prior about the nominal values of all free parameters (prior_deviation()), one pseudo-observation each: next
/// to nothing for what the readings determine, and what keeps the rest near the nominal arm. `names` are the parameters
/// that it decides, one a direction; empty: no prior. It counts in cost and covariance, and `names` in the degrees of
/// freedom.
struct WeakPrior {
  std::vector<std::string> names;
  Arm nominal;
};

/// Puts a solution of `system` under the weights of `fit` into it: arm, unknowns, linearisation, cost, residuals and
/// what the solver says of itself. `x` becomes the solution's.
void take_solution(Solution&& solution, const System& system, Eigen::VectorXd& x, ArmFit& fit);

/// redundancy_of() of all observations of a fit.
Redundancy redundancy_of(const Recording& recording, const Constraints& constraints, const ArmFit& fit,
                         const std::vector<Parameter>& free);

/// Whether the parameters found with a prior contradict it (chi-squared, 0.1 %): then the readings do not determine the
/// arm, and what the fit made of them is the bias of a nearly free direction.
bool contradicts(const WeakPrior& prior, const ArmFit& fit, const std::vector<Parameter>& free);

/// Solves, takes the noise from the residuals where it is not given (so that residuals of readings and certified
/// distances together have the χ² of their degrees of freedom), sets the weights accordingly, and solves again until
/// the noise converges. With a loss robust_fit() goes on from there.
/// `start` holds the free parameters' start and all others' values.
/// No solution: no degree of freedom left, no convergence.
Expected<ArmFit> fit_arm(const Recording& recording, const Constraints& constraints, const Arm& start,
                         const std::vector<Parameter>& free, const Noise& noise, const SolveOptions& options,
                         const WeakPrior& prior = {});

}  // namespace artcal
