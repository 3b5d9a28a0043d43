#pragma once

#include <string>

#include "identification/least_squares/linearisation.h"
#include "identification/problem/loss.h"
#include "identification/problem/system.h"

namespace artcal {

struct SolveOptions {
  Loss loss = Loss::None;
  int max_iterations = 100;
  double still = 1e-6;  ///< a step that moves nothing by more ends it, mm
  /// Of each x about prior_at, one pseudo-observation each (a weak prior: Tikhonov 1963); empty: none.
  /// The cost and the linearisation of the solution count it.
  Eigen::VectorXd prior_weights = {};
  Eigen::VectorXd prior_at = {};  ///< the x that the prior is about; empty: 0
  Folding folding = Folding::Reflections;
  bool linearise_solution = true;  ///< whether Solution::linearisation is asked for; it costs as much as a step does
};

/// How a solve ended. Only Converged leaves numbers that may be used.
enum class Termination {
  Converged,      ///< the parameters stand at a minimum
  NoConvergence,  ///< the iterations ran out; the parameters are the best found
  Failed,         ///< the numbers broke down; the parameters mean nothing
};

struct Solution {
  Eigen::VectorXd x;  ///< System::arm_at(x) is the arm
  Unknowns unknowns;
  Linearisation linearisation;  ///< at x and unknowns, if asked for
  Termination termination = Termination::Failed;
  int iterations = 0;
  double initial_cost = 0.0;  ///< half the sum of squared weighted residuals (of ρ with a loss)
  double final_cost = 0.0;
  std::string message;
};

/// Least squares over the free parameters and all unknowns, by Ceres with analytic Jacobians: Levenberg-
/// Marquardt that begins as Gauss-Newton. Groups of unknowns and artefact parameters are eliminated by Schur
/// complement, whichever side of an artefact leaves the smaller system (Component). A residual block is a Block with
/// all its readings, compressed (BlockRows): Ceres sees tens of rows where there may be thousands of readings. One
/// thread: sums keep their order, and so the result its bits.
Solution solve(const System& system, const Weights& weights, const Eigen::VectorXd& x_start, Unknowns start,
               const SolveOptions& options = {});

}  // namespace artcal
