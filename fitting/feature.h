#pragma once

#include <Eigen/Core>

namespace artcal {

/// The features that points are fitted to. Plain values, in the frame of the points they came from;
/// lengths in mm, angles in rad; normals and directions are unit vectors.
///
/// `parameters()` is the order in which a covariance counts them. Where it holds a unit vector or a point
/// that may slide (along a plane or an axis) the covariance is singular in that direction by design: it
/// then turns with the frame like any other tensor, with no chart to choose.

struct Sphere {
  static constexpr int parameter_count = 4;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
  /// (centre, radius)
  [[nodiscard]] Eigen::Matrix<double, parameter_count, 1> parameters() const;
};

struct Plane {
  static constexpr int parameter_count = 6;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< the centroid of the fitted points
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit
  /// (point, normal); the point moves along the normal only
  [[nodiscard]] Eigen::Matrix<double, parameter_count, 1> parameters() const;
};

struct Line {
  static constexpr int parameter_count = 6;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       ///< the centroid of the fitted points
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit
  /// (point, direction); the point moves across the line only
  [[nodiscard]] Eigen::Matrix<double, parameter_count, 1> parameters() const;
};

struct Circle {
  static constexpr int parameter_count = 7;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of the circle's plane, unit
  double radius = 0.0;
  /// (centre, normal, radius)
  [[nodiscard]] Eigen::Matrix<double, parameter_count, 1> parameters() const;
};

struct Cylinder {
  static constexpr int parameter_count = 7;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       ///< of the axis, abreast of the centroid of the fitted points
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of the axis, unit
  double radius = 0.0;
  /// (point, direction, radius); the point moves across the axis only
  [[nodiscard]] Eigen::Matrix<double, parameter_count, 1> parameters() const;
};

struct Cone {
  static constexpr int parameter_count = 8;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       ///< of the axis, abreast of the centroid of the fitted points
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of the axis, unit, from the apex into the opening
  double radius = 0.0;                                   ///< across the axis at `point`
  double half_angle = 0.0;                               ///< between axis and surface, in (0, π/2)
  [[nodiscard]] Eigen::Vector3d apex() const;
  /// (point, direction, radius, half_angle); the point moves across the axis only
  [[nodiscard]] Eigen::Matrix<double, parameter_count, 1> parameters() const;
};

/// Orthogonal distance from the feature to `p`, mm. Positive outside (away from the centre or axis; for
/// a plane on the normal's side). A line has no sides: never negative. A circle in space: the distance to
/// the curve, negative where p is nearer to the circle's axis than the circle. A cone is continued beyond
/// its apex as the straight line it is in section, so that the distance is smooth there.
double signed_distance(const Sphere& sphere, const Eigen::Vector3d& p);
double signed_distance(const Plane& plane, const Eigen::Vector3d& p);
double signed_distance(const Line& line, const Eigen::Vector3d& p);
double signed_distance(const Circle& circle, const Eigen::Vector3d& p);
double signed_distance(const Cylinder& cylinder, const Eigen::Vector3d& p);
double signed_distance(const Cone& cone, const Eigen::Vector3d& p);

/// The part of a circle's distance that lies in its plane: what the metrology convention looks at.
double radial_distance(const Circle& circle, const Eigen::Vector3d& p);

}  // namespace artcal
