#include "identification/residual.h"

#include <cmath>

#include <Eigen/Geometry>

namespace artcal {
namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

// exp(w + δ) = exp(w)·exp(Jr(w)·δ) to first order (Chirikjian 2012, vol. 2, Eq. 10.86).
Eigen::Matrix3d right_jacobian(const Eigen::Vector3d& w) {
  const double angle2 = w.squaredNorm();
  const Eigen::Matrix3d k = cross_matrix(w);
  if (angle2 < 1e-12) {
    return Eigen::Matrix3d::Identity() - 0.5 * k + k * k / 6.0;
  }
  const double angle = std::sqrt(angle2);
  return Eigen::Matrix3d::Identity() - (1.0 - std::cos(angle)) / angle2 * k +
         (angle - std::sin(angle)) / (angle2 * angle) * k * k;
}

}  // namespace

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& turning) {
  const double angle = turning.norm();
  if (angle == 0.0) {
    return Eigen::Matrix3d::Identity();
  }
  return Eigen::AngleAxisd(angle, turning / angle).toRotationMatrix();
}

Rigid base_from_artefact(const GroupState& group) {
  return {group.reference * rotation_of(group.values.head<3>()), group.values.segment<3>(3)};
}

FeatureResidual::FeatureResidual(const FeatureConstraint& constraint, const Eigen::Matrix3d& reference,
                                 const double* group_values)
    : constraint_(constraint) {
  if (constraint.location == Location::Unknown) {
    columns_ = 3;
    first_column_ = constraint.offset;
    point_in_base_ = Eigen::Vector3d::Map(group_values + constraint.offset);
  } else if (constraint.location == Location::Posed) {
    columns_ = 6;
    const Eigen::Vector3d turning = Eigen::Vector3d::Map(group_values);
    artefact_from_base_ = (reference * rotation_of(turning)).transpose();
    origin_in_base_ = Eigen::Vector3d::Map(group_values + 3);
    right_jacobian_ = right_jacobian(turning);
  }
}

Residual FeatureResidual::at(int reading, const Eigen::Vector3d& tip_in_base, bool derivatives) const {
  Residual r;
  r.rows = constraint_.dimension();
  const bool posed = constraint_.location == Location::Posed;
  Eigen::Vector3d e;
  if (constraint_.location == Location::Unknown) {
    e = tip_in_base - point_in_base_;
  } else if (posed) {
    e = artefact_from_base_ * (tip_in_base - origin_in_base_);
  } else {
    e = tip_in_base - constraint_.known[reading];
  }
  if (derivatives) {
    if (posed) {
      r.by_tip = artefact_from_base_;
      r.by_unknowns.leftCols<3>() = cross_matrix(e) * right_jacobian_;
      r.by_unknowns.rightCols<3>() = -artefact_from_base_;
    } else {
      r.by_tip.setIdentity();
      r.by_unknowns.leftCols<3>() = -Eigen::Matrix3d::Identity();
    }
  }
  if (posed) {
    e -= constraint_.known[reading];
  }
  if (constraint_.demand == Demand::Coincide) {
    r.value = e;
    return r;
  }
  const double distance = e.norm();
  r.value[0] = distance - constraint_.distances[reading];
  if (derivatives) {
    // At the centre itself the direction is undefined; any one will do to leave it.
    const Eigen::RowVector3d direction = distance > 0.0 ? e.transpose() / distance : Eigen::RowVector3d(0.0, 0.0, 1.0);
    r.by_tip.row(0) = direction * r.by_tip;
    r.by_unknowns.row(0).head(columns_) = direction * r.by_unknowns.leftCols(columns_);
  }
  return r;
}

}  // namespace artcal
