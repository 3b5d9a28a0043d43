#pragma once

#include <vector>

#include <Eigen/Core>

#include "identification/monte_carlo/arrow_factor.h"

namespace artcal {

/// How much a fit moves where observations count by loss weights W: of an observation's rows a, a·C·AᵀW²A·C·aᵀ with
/// C = (AᵀWA)⁻¹. Unknowns that a does not reach follow those that it does, so that their share is a quadratic form of
/// the arm's parameters, or of these and the interface of the same component (see Component).
class FitSpread {
 public:
  /// `factor` is that of AᵀWA; of the system with the blocks of `squared`, AᵀW²A is the normal matrix.
  FitSpread(const ArrowFactor& factor, const Linearisation& squared, int arm_size);

  /// `solved` is what ArrowFactor::fully_solved() returns of the rows.
  [[nodiscard]] Eigen::MatrixXd of(const Block& block, const Eigen::Ref<const Eigen::MatrixXd>& solved) const;

 private:
  struct Part {
    Eigen::MatrixXd rows;            // of AᵀW²A's factor, by [own | interface | arm]
    Eigen::MatrixXd following_rows;  // the same where the own unknowns follow, by [interface | arm]
    int component = -1;              // into components_
  };
  struct Gathered {                // of all parts of one component
    Eigen::MatrixXd by_interface;  // by [interface | arm], the leaves following
    Eigen::MatrixXd by_arm;        // the interface following too
  };

  const ArrowFactor& factor_;
  Eigen::Index arm_size_;
  std::vector<Part> parts_;  // as ArrowFactor::eliminated()
  std::vector<Gathered> components_;
  Eigen::MatrixXd by_arm_;  // of all
};

}  // namespace artcal
