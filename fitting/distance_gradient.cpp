#include "fitting/distance_gradient.h"

#include <cmath>

namespace artcal::fitting {
namespace {

/// A point as an axis sees it.
struct Cylindrical {
  Eigen::Vector3d outwards;  ///< unit, from the axis to the point; zero on the axis
  double radius = 0.0;
  double height = 0.0;
};

Cylindrical about(const Eigen::Vector3d& point, const Eigen::Vector3d& direction, const Eigen::Vector3d& p) {
  const Eigen::Vector3d way = p - point;
  Cylindrical seen;
  seen.height = direction.dot(way);
  const Eigen::Vector3d across = way - seen.height * direction;
  seen.radius = across.norm();
  seen.outwards = seen.radius > 0.0 ? Eigen::Vector3d(across / seen.radius) : Eigen::Vector3d::Zero();
  return seen;
}

}  // namespace

DistanceGradient<Sphere> distance_gradient(const Sphere& sphere, const Eigen::Vector3d& p) {
  DistanceGradient<Sphere> gradient;
  gradient << -(p - sphere.centre).normalized(), -1.0;
  return gradient;
}

DistanceGradient<Plane> distance_gradient(const Plane& plane, const Eigen::Vector3d& p) {
  DistanceGradient<Plane> gradient;
  gradient << -plane.normal, p - plane.point;
  return gradient;
}

DistanceGradient<Line> distance_gradient(const Line& line, const Eigen::Vector3d& p) {
  const Cylindrical seen = about(line.point, line.direction, p);
  DistanceGradient<Line> gradient;
  gradient << -seen.outwards, -seen.height * seen.outwards;
  return gradient;
}

DistanceGradient<Circle> distance_gradient(const Circle& circle, const Eigen::Vector3d& p) {
  const Cylindrical seen = about(circle.centre, circle.normal, p);
  const double radial = seen.radius - circle.radius;
  const double distance = std::copysign(std::hypot(radial, seen.height), radial);
  DistanceGradient<Circle> gradient = DistanceGradient<Circle>::Zero();
  if (distance != 0.0) {
    const double r = radial / distance;
    const double h = seen.height / distance;
    gradient << -r * seen.outwards - h * circle.normal, h * (p - circle.centre) - r * seen.height * seen.outwards, -r;
  }
  return gradient;
}

DistanceGradient<Cylinder> distance_gradient(const Cylinder& cylinder, const Eigen::Vector3d& p) {
  const Cylindrical seen = about(cylinder.point, cylinder.direction, p);
  DistanceGradient<Cylinder> gradient;
  gradient << -seen.outwards, -seen.height * seen.outwards, -1.0;
  return gradient;
}

DistanceGradient<Cone> distance_gradient(const Cone& cone, const Eigen::Vector3d& p) {
  const Cylindrical seen = about(cone.point, cone.direction, p);
  const double c = std::cos(cone.half_angle);
  const double s = std::sin(cone.half_angle);
  DistanceGradient<Cone> gradient;
  gradient << -c * seen.outwards + s * cone.direction, -c * seen.height * seen.outwards - s * (p - cone.point), -c,
      -s * (seen.radius - cone.radius) - c * seen.height;
  return gradient;
}

}  // namespace artcal::fitting
