#pragma once

#include <string>

#include "identification/loss.h"
#include "identification/system.h"

namespace artcal {

struct SolveOptions {
  Loss loss = Loss::None;
  int max_iterations = 100;
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
  Termination termination = Termination::Failed;
  int iterations = 0;
  double initial_cost = 0.0;  ///< half the sum of squared weighted residuals
  double final_cost = 0.0;
  std::string message;
};

/// Least squares over the free parameters and all unknowns, by Ceres with analytic Jacobians: Levenberg-
/// Marquardt that begins as Gauss-Newton. The groups of unknowns are eliminated by Schur complement. One
/// residual block is a run of one feature's readings; with a robust loss it is one reading, so that the
/// loss sees readings. One thread: sums keep their order, and so the result its bits.
Solution solve(const System& system, const Weights& weights, const Eigen::VectorXd& x_start, Unknowns start,
               const SolveOptions& options = {});

/// ρ(s) of a loss and its derivative at s, the squared residual in units of its variance.
struct LossValue {
  double value = 0.0;
  double slope = 1.0;
};
LossValue loss_at(Loss loss, double s);

}  // namespace artcal
