#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "fitting/feature.h"

namespace artcal::fitting {

/// A round surface, described at a point of itself near the data instead of at its centre or apex, so
/// that a radius of ten metres seen on a small patch costs no digits (after Lukács, Marshall, Martin,
/// "Faithful least-squares fitting of spheres, cylinders, cones and tori", ECCV 1998): a point, the frame
/// (normal, across, ruling) of the surface there, the curvature across the ruling, and for a cone the
/// reciprocal distance to the apex along the ruling.
struct RoundState {
  Eigen::Vector3d point;
  Eigen::Matrix3d frame;  ///< columns: outward normal N, tangent b across the ruling, ruling g
  double curvature;       ///< κ, across the ruling, of the section along the normal; 1/unit
  double taper = 0.0;     ///< μ = 1/distance to the apex; 0: a cylinder, a circle, a sphere

  /// The same in terms of the axis: k = √(κ² + μ²) is the curvature of the section across the axis and
  /// tan ψ = μ/κ, so that no angle is wanted and nothing is divided by a small number.
  struct Section {
    double k, sine, cosine;  ///< of ψ
    Eigen::Matrix3d frame;   ///< columns: radial n, tangent b, axis a
  };
  [[nodiscard]] Section section() const;
};

/// Distance within one section, a plane across the axis: (x, y) from the surface point, x radial.
/// D = (w − 1)/k with w = √(1 + 2·k·e), e = k·(x² + y²)/2 + x, written so that k → 0 is harmless.
struct SectionDistance {
  double distance, w, ux, uy;  ///< (ux, uy): unit gradient
  double bend;                 ///< T = (x² + y² − D²)/2; ∂D/∂k = T/w
};

inline SectionDistance section_distance(double k, double x, double y) {
  const double squared = x * x + y * y;
  const double e = 0.5 * k * squared + x;
  const double w = std::sqrt(std::max(1.0 + 2.0 * k * e, 1e-30));
  const double distance = 2.0 * e / (1.0 + w);
  return {distance, w, (1.0 + k * x) / w, k * y / w, 0.5 * (squared - distance * distance)};
}

inline RoundState::Section RoundState::section() const {
  const double size = std::hypot(curvature, taper);
  const double k = std::copysign(size, curvature);
  const double sine = size == 0.0 ? 0.0 : taper / k;
  const double cosine = size == 0.0 ? 1.0 : curvature / k;
  Eigen::Matrix3d axial;
  axial.col(0) = cosine * frame.col(0) + sine * frame.col(2);
  axial.col(1) = frame.col(1);
  axial.col(2) = cosine * frame.col(2) - sine * frame.col(0);
  return {k, sine, cosine, axial};
}

/// The frame turned by a rotation vector given in its own axes.
inline Eigen::Matrix3d turned(const Eigen::Matrix3d& frame, const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle == 0.0) {
    return frame;
  }
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
  // Re-orthonormalised, or a hundred steps would leave their rounding in the axis.
  Eigen::Matrix3d next = frame * turn;
  next.col(0).normalize();
  next.col(1) = (next.col(1) - next.col(0) * next.col(0).dot(next.col(1))).normalized();
  next.col(2) = next.col(0).cross(next.col(1));
  return next;
}

}  // namespace artcal::fitting
