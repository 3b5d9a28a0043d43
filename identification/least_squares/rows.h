#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "identification/least_squares/blocks.h"
#include "identification/least_squares/residual.h"
#include "identification/problem/system.h"

namespace artcal {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Where weighted residuals of a run of one feature's readings and their derivatives go: the rows of a
/// row-major matrix with `stride` numbers a row, `residuals` pointing to the column of the residuals,
/// `by_arm` to the first of System::arm_size() columns, `by_group` and `by_shared` to the first columns of the
/// group's unknowns and of the artefact parameters from `first_shared` on, which must be zero before. All but the
/// residuals may be null.
struct RowsOut {
  std::ptrdiff_t stride = 1;
  double* residuals = nullptr;
  double* by_arm = nullptr;
  double* by_group = nullptr;
  double* by_shared = nullptr;
  int first_shared = 0;  ///< into Constraints::shared
};

/// Computes the rows of readings [first, first + count) of a feature, dimension() rows a reading. `sweeps` come from
/// sweeps_of() at the arm in question, `residual` is the feature's at the unknowns in question.
void weighted_rows(const System& system, const FeatureConstraint& feature, const FeatureWeights& weights,
                   const std::vector<ForwardKinematics>& kinematics_by_probe, const FeatureResidual& residual,
                   int first, int count, const RowsOut& out);

/// Columns of a block's weighted rows: its group's unknowns, its artefact parameters, System::free, what else is asked
/// of them, the residual.
struct BlockColumns {
  int unknowns = 0;
  FeatureParameters parameters{};
  int arm = 0;
  int beside = 0;

  BlockColumns(const Block& block, const System& system, int beside_arm = 0)
      : unknowns(block.unknowns), parameters(block.parameters), arm(system.arm_size()), beside(beside_arm) {}

  [[nodiscard]] int nuisance() const { return unknowns + parameters.size; }
  [[nodiscard]] int fitted() const { return nuisance() + arm; }
  [[nodiscard]] int residual() const { return fitted() + beside; }
  [[nodiscard]] int all() const { return residual() + 1; }
  /// For weighted_rows() into a row-major matrix of these columns, from the row that begins at `row`.
  [[nodiscard]] RowsOut out(double* row) const;
};

/// Where a block's residuals are taken: its group's reference and values, and the values of all artefact parameters.
struct BlockPoint {
  const GroupReference& reference;
  const double* values = nullptr;
  const double* shared = nullptr;
};
/// REQUIRES: `unknowns` outlives it.
BlockPoint point_of(const Block& block, const Unknowns& unknowns);

/// What a block observes: the readings of a feature with their residual, a certified distance that binds, and what a
/// certificate states of an artefact parameter, in the block's column `column` of parameters.
struct FeatureReadings {
  int index = 0;  ///< into Constraints::features
  const FeatureConstraint& feature;
  const FeatureResidual& residual;
};
struct BindingDistance {
  int index = 0;  ///< into Constraints::distances
  const DistanceConstraint& distance;
};
struct CertifiedParameter {
  int index = 0;  ///< into Constraints::shared
  int column = 0;
  const ArtefactParameter& parameter;
};

/// Calls `visit` with each of these, in this order: the one walk over a block that all share who make rows of it.
template <typename Visit>
void for_each_observation(const Constraints& constraints, const Block& block, const BlockPoint& point, Visit&& visit) {
  for (const int f : block.features) {
    const FeatureConstraint& feature = constraints.features[static_cast<std::size_t>(f)];
    const FeatureResidual residual(feature, point.reference, point.values, point.shared);
    visit(FeatureReadings{f, feature, residual});
  }
  for (const int d : block.distances) {
    visit(BindingDistance{d, constraints.distances[static_cast<std::size_t>(d)]});
  }
  for (int i = 0; block.has_certificate && i < block.parameters.size; ++i) {
    const int s = block.parameters.first + i;
    visit(CertifiedParameter{s, i, constraints.shared[static_cast<std::size_t>(s)]});
  }
}

/// Weighted residual of a certified distance, and its derivative by the group's unknowns (may be null): between
/// two points or centres, or between two planes along their common axis.
double weighted_distance(const DistanceConstraint& distance, const Constraints& constraints, double weight,
                         const double* group_values, double* by_group);

}  // namespace artcal
