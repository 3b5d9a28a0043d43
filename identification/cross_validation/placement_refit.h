#pragma once

#include <memory>
#include <optional>

#include "identification/cross_validation/gradient_expansion.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/least_squares/gram_tree.h"

namespace artcal {

/// Identifies an arm from the readings of all placements but one, beginning at the solution for all: Gauss-Newton steps
/// with exact gradients and the normal matrix of the solution without that placement (GramTree), until what is left of
/// the way is a ten-millionth of a standard deviation. Where the readings determine the parameters, it ends where a
/// whole identification of the other placements by least squares does, with the same parameters free. Of many
/// placements the gradient is expanded to second order once (GradientExpansion), so that each costs the same however
/// many others there are; where third-order terms might count, the exact gradients decide. Const once made; threads
/// share it.
class PlacementRefit {
 public:
  /// `system` is make_system() at the arm of the fit; all arguments are referred to. `noise` as given, or as the fit
  /// found it. The gradient is expanded on `threads` threads (0: all) where there are enough placements for it to be
  /// worth it, or as `expand` says. No solution: see estimate_nuisance_parameters().
  static Expected<PlacementRefit> of(const System& system, const ArmFit& fit, const Recording& recording,
                                     const Noise& noise, int threads = 1, std::optional<bool> expand = {});

  /// An arm without a placement and the covariance of its parameters under the weights of the fit; and an upper bound
  /// of it, times the reduced chi-squared where that is above 1.
  struct Refit {
    Arm arm;
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd covariance_bound;
    bool expanded = false;  ///< by the expansion, without exact gradients
  };

  /// The arm without the placement. Nothing where the other readings leave a parameter weak beyond doubt, or where the
  /// steps do not converge fast: then only a whole identification can say what can be had.
  [[nodiscard]] std::optional<Refit> without(const Placement& placement) const;

 private:
  struct Trees {  // at addresses of their own: each refers to its linearisation
    explicit Trees(PlacedLinearisation placed) : linearisation(std::move(placed)), tree(linearisation) {}
    PlacedLinearisation linearisation;
    GramTree tree;
  };
  [[nodiscard]] Refit refit_of(Arm arm, const GramTree::Without& factor, int degrees_of_freedom) const;
  [[nodiscard]] int degrees_of_freedom(const Placement& placement) const;
  [[nodiscard]] Unknowns unknowns_at(const Eigen::VectorXd& numbers) const;

  const System* system_ = nullptr;
  const ArmFit* fit_ = nullptr;
  Noise noise_;
  Weights weights_;
  std::vector<Block> blocks_;
  std::vector<std::optional<Placement>> places_;
  StateLayout layout_;
  Eigen::VectorXd start_;     // numbers of the fit
  Eigen::VectorXd gradient_;  // there
  std::shared_ptr<const Trees> at_fit_;
  std::shared_ptr<const Trees> consistent_;  // the same with every reading on its constraint, for the rank
  std::optional<GradientExpansion> expansion_;
};

}  // namespace artcal
