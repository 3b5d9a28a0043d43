#pragma once

#include <array>

#include <Eigen/Core>

#include "artefacts/constraints/constraint.h"
#include "core/rigid.h"
#include "identification/problem/system.h"

namespace artcal {

/// The residual of one reading and its derivatives; the first `rows` rows count.
struct Residual {
  int rows = 0;
  Eigen::Vector3d value;                    ///< mm
  Eigen::Matrix3d by_tip;                   ///< by the tip's coordinates in the base frame, mm/mm
  Eigen::Matrix<double, 3, 7> by_unknowns;  ///< by a point or plane (3 columns) or the pose (5 to 7), mm/mm and mm/rad
  Eigen::Matrix3d by_errors;                ///< by the errors of certified coordinates (FeatureConstraint::first_error)
  double by_tip_radius = 0.0;               ///< of its only row
  double by_ball_radius = 0.0;              ///< by the shared radius of the ball
};

/// The axis that the planes of a group share, at its tilts.
struct PlaneAxis {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit, in the base frame
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 2> by_tilts;  ///< of the direction, 1/mm

  PlaneAxis() = default;
  PlaneAxis(const GroupReference& reference, const double* group_values);
};

/// One feature's residual as a function of the tip, at given unknowns. With c the point of the reading:
///   Unknown, Base:  e = P − c
///   Posed:          e = base_from_artefact⁻¹ · P − c, in the artefact's frame: there a motion of the
///                   base moves nothing, so that what an unknown frame hides stays hidden exactly
///   Coincide:       r = e              (three rows)
///   AtDistance:     r = |e| − ρ        (one row; signed and smooth away from the centre)
///   OnBall:         r = |e| − (R + r0) with the radii of ball and tip
///   OnPlane:        r = n·e − r0       with the outward normal n, in the same frame as e
/// An unknown plane with its axis a, see GroupState: r = ±(a·(P − origin) − o) − r0, o being the group's place
/// and the certified height for a face of a gauge.
/// Certified coordinates c carry their errors, if these are unknowns: c + expansion·errors.
class FeatureResidual {
 public:
  /// `shared` holds the values of Constraints::shared; it may be null where the constraint has none of them.
  FeatureResidual(const FeatureConstraint& constraint, const GroupReference& reference, const double* group_values,
                  const double* shared);

  /// Columns of Residual::by_unknowns: 0, 3 or 5 to 7, and where each belongs in the group.
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int column(int i) const { return column_[i]; }

  /// Of an unknown point or ball: where it is, mm; and the radius of the ball.
  [[nodiscard]] const Eigen::Vector3d& point_in_base() const { return point_in_base_; }
  [[nodiscard]] double ball_radius() const { return ball_radius_; }

  /// `reading` counts FeatureConstraint::readings.
  [[nodiscard]] Residual at(int reading, const Eigen::Vector3d& tip_in_base, double tip_radius, bool derivatives) const;

 private:
  [[nodiscard]] Eigen::Vector3d certified_point(int reading) const;
  [[nodiscard]] Residual at_unknown_plane(const Eigen::Vector3d& tip_in_base, double tip_radius) const;

  const FeatureConstraint& constraint_;
  // Its kind, looked up once and not for every reading.
  bool is_point_ = false;
  bool is_unknown_plane_ = false;
  const OnPlane* plane_ = nullptr;
  const AtDistance* lengths_ = nullptr;
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();  // of a plane, as certified
  int columns_ = 0;
  std::array<int, 7> column_{0, 1, 2, 3, 4, 5, 6};
  double ball_radius_ = 0.0;
  Eigen::Vector3d error_ = Eigen::Vector3d::Zero();  // of the certified coordinates
  Eigen::Vector3d point_in_base_;
  PlaneAxis axis_;
  double place_ = 0.0;  // of the plane along the axis
  double side_ = 1.0;
  Eigen::Matrix3d artefact_from_base_;  // rotation
  Eigen::Vector3d origin_in_base_;
  int turning_size_ = 3;               // columns of the turning
  Eigen::Matrix3d right_jacobian_;     // of exp at the turning, by its unknowns
  const PointLine* scaled_ = nullptr;  // the line across which points are displaced (PoseTurn::Scaled)
  Eigen::Matrix2d displacement_;       // by this
};

/// 1 where the tips on an unknown plane lie on the side of its axis, else -1.
double side_of(const FeatureConstraint& plane, const GroupReference& reference);

/// exp: turning vector (rad) to rotation.
Eigen::Matrix3d rotation_of(const Eigen::Vector3d& rotation);

/// The pose of a group at its values.
Rigid base_from_artefact(const GroupState& group);

}  // namespace artcal
