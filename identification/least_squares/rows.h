#pragma once

#include <cstddef>

#include <Eigen/Core>

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

/// Weighted residual of a certified distance, and its derivative by the group's unknowns (may be null): between
/// two points or centres, or between two planes along their common axis.
double weighted_distance(const DistanceConstraint& distance, const Constraints& constraints, double weight,
                         const double* group_values, double* by_group);

}  // namespace artcal
