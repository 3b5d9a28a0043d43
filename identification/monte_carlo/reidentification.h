#pragma once

#include "core/error.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/monte_carlo/arrow_factor.h"
#include "identification/monte_carlo/gradient.h"

namespace artcal {

/// An identification that is done again and again with other readings of the same postures and other certificates: what
/// is free, the weights and the loss stay. Each time the least squares themselves are solved, not their linearisation
/// at the first solution: the first step takes the matrix from there, the second is Gauss-Newton's, and every one has
/// the exact gradient; the matrix is made anew where steps do not shrink fast, and kept where they do, which changes
/// the way but not where it ends. Where that leads nowhere, the solver of the first identification takes over. Const
/// once made; threads share it, each with a Scratch of its own.
class Reidentification {
 public:
  /// The solution that it begins from every time. `system` is make_system() at the arm of the fit, which it
  /// refers to, as to the fit. No solution: see ArrowFactor.
  static Expected<Reidentification> of(const System& system, const ArmFit& fit, const SolveOptions& options);

  struct Scratch {
    GradientScratch gradient;
  };
  [[nodiscard]] Scratch scratch() const { return {gradient_scratch(*system_)}; }

  struct Answer {
    Eigen::VectorXd x;  ///< System::arm_at(x) is the arm
    bool converged = false;
    int steps = 0;           ///< gradients
    int matrices = 0;        ///< linearisations
    bool by_solver = false;  ///< that of the first identification
  };
  /// `drawn` is the first system with other readings, as TrialInputs makes it.
  [[nodiscard]] Answer solve(const System& drawn, Scratch& scratch) const;

 private:
  [[nodiscard]] Unknowns unknowns_at(const Eigen::VectorXd& numbers) const;

  const System* system_ = nullptr;
  const ArmFit* fit_ = nullptr;
  SolveOptions options_;
  StateLayout layout_;
  std::optional<ArrowFactor> factor_;
  Eigen::VectorXd start_;
};

}  // namespace artcal
