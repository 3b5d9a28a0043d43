#pragma once

#include <Eigen/Core>

#include "artefacts/constraint.h"
#include "core/rigid.h"
#include "identification/system.h"

namespace artcal {

/// The residual of one reading and its derivatives; the first `rows` rows count.
struct Residual {
  int rows = 0;
  Eigen::Vector3d value;                    ///< mm
  Eigen::Matrix3d by_tip;                   ///< by the tip's coordinates in the base frame, mm/mm
  Eigen::Matrix<double, 3, 6> by_unknowns;  ///< by the point (3 columns) or the pose (6), mm/mm and mm/rad
};

/// One feature's residual as a function of the tip, at given unknowns. With c the point of the reading:
///   Unknown, Base:  e = P − c
///   Posed:          e = base_from_artefact⁻¹ · P − c, in the artefact's frame: there a motion of the
///                   base moves nothing, so that what an unknown frame hides stays hidden exactly
///   Coincide:       r = e          (three rows)
///   AtDistance:     r = |e| − ρ    (one row; signed and smooth away from the centre)
class FeatureResidual {
 public:
  FeatureResidual(const FeatureConstraint& constraint, const Eigen::Matrix3d& reference, const double* group_values);

  /// Columns of Residual::by_unknowns: 0, 3 or 6; in the group they begin at first_column().
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int first_column() const { return first_column_; }

  /// `reading` counts FeatureConstraint::readings.
  [[nodiscard]] Residual at(int reading, const Eigen::Vector3d& tip_in_base, bool derivatives) const;

 private:
  const FeatureConstraint& constraint_;
  int columns_ = 0;
  int first_column_ = 0;
  Eigen::Vector3d point_in_base_;
  Eigen::Matrix3d artefact_from_base_;  // rotation
  Eigen::Vector3d origin_in_base_;
  Eigen::Matrix3d right_jacobian_;  // of exp at the turning
};

/// exp: turning vector (rad) to rotation.
Eigen::Matrix3d rotation_of(const Eigen::Vector3d& turning);

/// The pose of a group at its values.
Rigid base_from_artefact(const GroupState& group);

}  // namespace artcal
