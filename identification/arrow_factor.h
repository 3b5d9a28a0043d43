#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/error.h"
#include "identification/linearisation.h"

namespace artcal {

/// Where the numbers of a system stand in one vector: the unknowns of each group, the shared ones, then the arm's x.
struct NumberLayout {
  std::vector<Eigen::Index> groups;  ///< where each begins; as Constraints::groups
  Eigen::Index common = 0;           ///< where the shared ones begin; the arm follows them
  Eigen::Index arm = 0;
  Eigen::Index size = 0;
};
NumberLayout layout_of(const System& system);

/// A triangular factor of all numbers of a system: that of [group | common] for each group of unknowns, and that of
/// what all have in common, the groups eliminated. Solves with RᵀR, the normal matrix, without forming it.
class ArrowFactor {
 public:
  /// No solution: some unknown or parameter is not determined.
  static Expected<ArrowFactor> of(const Linearisation& linearisation, const NumberLayout& layout);

  /// δ with RᵀR·δ = gradient, and |R·δ|, its length in standard deviations where weights are their inverse.
  struct Step {
    Eigen::VectorXd numbers;
    double length = 0.0;
  };
  [[nodiscard]] Step solve(const Eigen::VectorXd& gradient) const;

  /// R⁻ᵀ·aᵀ of rows a = [the unknowns of a block | common] that have no part in other groups, a column each: with Y of
  /// weighted rows YᵀY is their part of the hat matrix. `block` counts Linearisation::triangles.
  [[nodiscard]] Eigen::MatrixXd half_solved(std::size_t block, const Eigen::Ref<const Eigen::MatrixXd>& rows) const;
  /// R⁻¹·y of these, of the block's unknowns and the common ones: with half_solved() their columns of (RᵀR)⁻¹·aᵀ.
  [[nodiscard]] Eigen::MatrixXd solved(std::size_t block, const Eigen::MatrixXd& half) const;
  /// How the unknowns of a block follow the common ones where its own gradient stays zero.
  [[nodiscard]] Eigen::MatrixXd following(std::size_t block) const;

 private:
  struct Group {
    Eigen::MatrixXd own;        // upper triangular
    Eigen::MatrixXd by_common;  // beside it
  };
  NumberLayout layout_;
  std::vector<Group> groups_;
  Eigen::MatrixXd common_;  // upper triangular
};

}  // namespace artcal
