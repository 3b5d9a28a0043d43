#include "identification/least_squares/residual.h"

#include <cmath>

#include <Eigen/Geometry>

#include "core/cross_matrix.h"
#include "identification/problem/tips.h"

namespace artcal {
namespace {

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

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle == 0.0) {
    return Eigen::Matrix3d::Identity();
  }
  return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

Rigid base_from_artefact(const GroupState& group) {
  const GroupReference& reference = group.reference;
  if (reference.turn == PoseTurn::Free) {
    return {reference.rotation * rotation_of(group.values.head<3>()), group.values.segment<3>(3)};
  }
  const Eigen::Vector3d rotation = reference.line.artefact_from_line.leftCols<2>() * group.values.head<2>();
  return {reference.rotation * rotation_of(rotation), group.values.segment<3>(2)};
}

// With m = (s/size, t/size, 1) the direction is Q·m/|m|, and its derivative Q·(1 − m mᵀ/|m|²)/|m| · ∂m.
PlaneAxis::PlaneAxis(const GroupReference& reference, const double* group_values) : origin(reference.origin) {
  const Eigen::Vector3d m(group_values[0] / reference.size, group_values[1] / reference.size, 1.0);
  const double length = m.norm();
  direction = reference.rotation * m / length;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
  by_tilts = across * reference.rotation.leftCols<2>() / (length * reference.size);
}

double side_of(const FeatureConstraint& plane, const GroupReference& reference) {
  const GaugeFace* face = plane.face();
  return face != nullptr ? face->facing : reference.sides[plane.offset - 2];
}

FeatureResidual::FeatureResidual(const FeatureConstraint& constraint, const GroupReference& reference,
                                 const double* group_values, const double* shared)
    : constraint_(constraint),
      is_point_(constraint.is<Coincide>()),
      is_unknown_plane_(constraint.location == Location::Unknown && constraint.is<OnPlane>()),
      plane_(constraint.as<OnPlane>()),
      lengths_(constraint.as<AtDistance>()) {
  if (plane_ != nullptr && plane_->normal) {
    normal_ = *plane_->normal;
  }
  if (is_unknown_plane_) {
    columns_ = 3;
    column_[2] = constraint.offset;
    axis_ = PlaneAxis(reference, group_values);
    place_ = group_values[constraint.offset] + (plane_->face ? plane_->face->height : 0.0);
    side_ = side_of(constraint, reference);
  } else if (constraint.location == Location::Unknown) {
    columns_ = 3;
    column_ = {constraint.offset, constraint.offset + 1, constraint.offset + 2};
    point_in_base_ = Eigen::Vector3d::Map(group_values + constraint.offset);
  } else if (constraint.location == Location::Posed) {
    const bool is_free = reference.turn == PoseTurn::Free;
    const Eigen::Matrix3d& axes = reference.line.artefact_from_line;
    turning_size_ = is_free ? 3 : 2;
    const Eigen::Vector3d rotation = is_free ? Eigen::Vector3d(Eigen::Vector3d::Map(group_values))
                                             : Eigen::Vector3d(axes.leftCols<2>() * Eigen::Vector2d::Map(group_values));
    columns_ = turning_size_ + 3;
    artefact_from_base_ = (reference.rotation * rotation_of(rotation)).transpose();
    origin_in_base_ = Eigen::Vector3d::Map(group_values + turning_size_);
    right_jacobian_ = right_jacobian(rotation);
    if (!is_free) {
      right_jacobian_ = (right_jacobian_ * axes).eval();
    }
    if (reference.turn == PoseTurn::Scaled) {
      columns_ = 7;
      scaled_ = &reference.line;
      displacement_ << group_values[5], -group_values[6], group_values[6], group_values[5];
    }
  }
  if (constraint.first_error) {
    error_ = constraint.expansion * Eigen::Vector3d::Map(shared + *constraint.first_error);
  }
  if (const auto* ball = constraint.as<OnBall>()) {
    ball_radius_ = radius_of(*ball, constraint.expansion, shared);
  }
}

Eigen::Vector3d FeatureResidual::certified_point(int reading) const {
  const Eigen::Vector3d point = constraint_.known[reading] + error_;
  if (scaled_ == nullptr) {
    return point;
  }
  Eigen::Vector3d in_line = scaled_->artefact_from_line.transpose() * (point - scaled_->middle);
  in_line.head<2>() = (displacement_ * in_line.head<2>()).eval();
  return scaled_->middle + scaled_->artefact_from_line * in_line;
}

Residual FeatureResidual::at_unknown_plane(const Eigen::Vector3d& tip_in_base, double tip_radius) const {
  Residual r;
  r.rows = 1;
  const Eigen::Vector3d from_origin = tip_in_base - axis_.origin;
  r.value[0] = side_ * (axis_.direction.dot(from_origin) - place_) - tip_radius;
  if (constraint_.first_error) {
    r.value[0] -= normal_.dot(error_);
    r.by_errors.row(0) = -constraint_.expansion * normal_.transpose();
  }
  r.by_tip.row(0) = side_ * axis_.direction.transpose();
  r.by_unknowns.row(0).head<2>() = side_ * from_origin.transpose() * axis_.by_tilts;
  r.by_unknowns(0, 2) = -side_;
  r.by_tip_radius = -1.0;
  return r;
}

Residual FeatureResidual::at(int reading, const Eigen::Vector3d& tip_in_base, double tip_radius,
                             bool derivatives) const {
  if (is_unknown_plane_) {
    return at_unknown_plane(tip_in_base, tip_radius);
  }
  Residual r;
  r.rows = is_point_ ? 3 : 1;
  const bool posed = constraint_.location == Location::Posed;
  Eigen::Vector3d e;
  if (constraint_.location == Location::Unknown) {
    e = tip_in_base - point_in_base_;
  } else if (posed) {
    e = artefact_from_base_ * (tip_in_base - origin_in_base_);
  } else {
    e = tip_in_base - constraint_.known[reading] - error_;
  }
  if (derivatives) {
    if (posed) {
      r.by_tip = artefact_from_base_;
      r.by_unknowns.leftCols<3>() = cross_matrix(e) * right_jacobian_;
      r.by_unknowns.middleCols<3>(turning_size_) = -artefact_from_base_;
      if (scaled_ != nullptr) {
        const auto across = scaled_->artefact_from_line.leftCols<2>();
        const Eigen::Vector2d d = across.transpose() * (constraint_.known[reading] + error_ - scaled_->middle);
        r.by_unknowns.col(5) = -across * d;
        r.by_unknowns.col(6) = -across * Eigen::Vector2d(-d.y(), d.x());
      }
    } else {
      r.by_tip.setIdentity();
      r.by_unknowns.leftCols<3>() = -Eigen::Matrix3d::Identity();
    }
    r.by_errors = -constraint_.expansion * Eigen::Matrix3d::Identity();
    if (scaled_ != nullptr) {
      Eigen::Matrix3d displaced = scaled_->artefact_from_line;
      displaced.leftCols<2>() = (displaced.leftCols<2>() * displacement_).eval();
      r.by_errors = -constraint_.expansion * displaced * scaled_->artefact_from_line.transpose();
    }
  }
  if (posed) {
    e -= certified_point(reading);
  }
  if (is_point_) {
    r.value = e;
    return r;
  }
  Eigen::RowVector3d direction = normal_.transpose();
  if (plane_ != nullptr) {
    r.value[0] = direction * e - tip_radius;
  } else {
    const double distance = e.norm();
    // At the centre itself the direction is undefined; any one will do to leave it.
    direction = distance > 0.0 ? Eigen::RowVector3d(e.transpose() / distance) : Eigen::RowVector3d(0.0, 0.0, 1.0);
    r.value[0] = distance - (lengths_ == nullptr ? ball_radius_ + tip_radius : lengths_->distances[reading]);
  }
  if (derivatives) {
    r.by_tip.row(0) = direction * r.by_tip;
    r.by_unknowns.row(0).head(columns_) = direction * r.by_unknowns.leftCols(columns_);
    r.by_errors.row(0) = direction * r.by_errors;
    r.by_tip_radius = lengths_ != nullptr ? 0.0 : -1.0;
    r.by_ball_radius = -constraint_.expansion;
  }
  return r;
}

}  // namespace artcal
