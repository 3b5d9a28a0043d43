#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "identification/cross_validation/expansion_unit.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/least_squares/gram_tree.h"
#include "identification/problem/system.h"

namespace artcal {

/// The gradient of the sum of squares as a function of the arm's x and the artefact parameters (g, together), each
/// group's unknowns at their minimum, expanded about a fit to second order:
///     G(g₀ + δ) = G(g₀) + H·δ + ½·T[δ, δ]
/// It is a sum over placements, so that the expansion of all but one is that of all less that one's: all placements are
/// left out in turn for the price of some hundred passes over the readings, whatever their number. Where weights depend
/// on the posture H and T have their change.
///
/// Along g the unknowns u of a group move by L·δ, L by the fit's own linear system; what this leaves out is the product
/// of two terms that are each as small as a residual beside a radius. T has nothing that a residual multiplies, which
/// is smaller by the same ratio. H is known to its rounding, because derivatives by differences stand only where a
/// residual multiplies them.
class GradientExpansion {
 public:
  /// `blocks` and `places` as placed_blocks() has them, `weights` those at the fit. Nothing where readings do not
  /// determine a group, where there is more than one group's unknowns to a placement's block, or where the unknowns
  /// kept are too many.
  static std::optional<GradientExpansion> of(const System& system, const ArmFit& fit, const Noise& noise,
                                             const Weights& weights, const std::vector<Block>& blocks,
                                             const std::vector<std::optional<Placement>>& places, int threads);

  /// The x where the gradient of all other placements is zero; `left` is what the terms left out may move it by, in
  /// standard deviations, estimated from how the terms that are there shrink.
  struct Minimum {
    Eigen::VectorXd x;
    double left = 0.0;
  };
  [[nodiscard]] std::optional<Minimum> without(const Placement& placement) const;

 private:
  /// The terms kept of each placement: T, by its size, in half the memory.
  struct KeptTerms {
    Eigen::VectorXd gradient;
    Eigen::MatrixXd slope;
    Eigen::MatrixXf curvature;
  };

  Eigen::Index shared_ = 0;  // artefact parameters before the arm's x
  ExpansionTerms all_;
  std::vector<std::pair<Placement, KeptTerms>> own_;  // in order
};

}  // namespace artcal
