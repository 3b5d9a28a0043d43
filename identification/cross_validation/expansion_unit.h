#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>

#include "identification/least_squares/arm_fit.h"
#include "identification/least_squares/gram_tree.h"
#include "identification/least_squares/rows.h"
#include "identification/problem/system.h"

namespace artcal {

/// The gradient of a part of the sum of squares, by the artefact parameters and the arm's x, to second order.
struct ExpansionTerms {
  Eigen::VectorXd gradient;
  Eigen::MatrixXd slope;
  Eigen::MatrixXd curvature;  ///< T, a column for each pair j ≤ k of steps
};

/// The number of pairs j ≤ k of `size` numbers.
Eigen::Index pairs_of(Eigen::Index size);

/// The step of the differences, in physical units, mm: far below a ball's radius, far above rounding.
constexpr double expansion_step = 2e-3;

/// The kinematics of one point along the expansion.
struct DisplacedArm {
  Arm arm;
  std::vector<ForwardKinematics> kinematics_by_probe;
};

/// The blocks that share a group's unknowns u, or one block without a group. Its rows are [u | g | residual].
class ExpansionUnit {
 public:
  ExpansionUnit(const System& system, const ArmFit& fit, const Noise& noise, const Weights& weights,
                std::vector<const Block*> blocks);

  /// `along[2·j]` and `along[2·j + 1]` are the arms displaced forward and back along the j-th number of the arm. False
  /// where the group is not determined.
  bool expand(const DisplacedArm& at, const std::vector<DisplacedArm>& along, ExpansionTerms& terms) const;

 private:
  using FeatureWeightsList = std::map<int, FeatureWeights>;

  // ∂/∂g_k of the rows of g, the unknowns following, under the weights of the fit; and where weights depend on the
  // posture, the change of the rows of the fit, residuals and all, by that of the weights.
  void differentiate(const DisplacedArm& at, const std::vector<DisplacedArm>& along, Eigen::Index k,
                     const Eigen::MatrixXd& follow, Eigen::MatrixXd& bent, Eigen::MatrixXd& weighed) const;
  [[nodiscard]] FeatureWeightsList weights_of(const DisplacedArm& at, const Eigen::VectorXd& values,
                                              const Eigen::VectorXd& shared) const;
  [[nodiscard]] const FeatureWeights& chosen(int f, const FeatureWeightsList& list) const;
  [[nodiscard]] RowMatrix rows_at(const DisplacedArm& at, const Eigen::VectorXd& values, const Eigen::VectorXd& shared,
                                  const FeatureWeightsList& list) const;

  const System& system_;
  const ArmFit& fit_;
  const Noise& noise_;
  const Weights& weights_;
  std::vector<const Block*> blocks_;
  int group_ = -1;
  Eigen::Index unknowns_ = 0;
  Eigen::Index kept_ = 0;
  Eigen::Index size_ = 0;
  Eigen::VectorXd values_, shared_;  // at the fit
};

}  // namespace artcal
