#include "fitting/feature.h"

#include <cmath>

#include <Eigen/Geometry>

namespace artcal {
namespace {

// |(p - point) × direction|: no digits lost near the axis, unlike a difference of squares.
double distance_to_axis(const Eigen::Vector3d& point, const Eigen::Vector3d& direction, const Eigen::Vector3d& p) {
  return (p - point).cross(direction).norm();
}

}  // namespace

Eigen::Matrix<double, 4, 1> Sphere::parameters() const { return {centre.x(), centre.y(), centre.z(), radius}; }

Eigen::Matrix<double, 6, 1> Plane::parameters() const {
  return (Eigen::Matrix<double, 6, 1>() << point, normal).finished();
}

Eigen::Matrix<double, 6, 1> Line::parameters() const {
  return (Eigen::Matrix<double, 6, 1>() << point, direction).finished();
}

Eigen::Matrix<double, 7, 1> Circle::parameters() const {
  return (Eigen::Matrix<double, 7, 1>() << centre, normal, radius).finished();
}

Eigen::Matrix<double, 7, 1> Cylinder::parameters() const {
  return (Eigen::Matrix<double, 7, 1>() << point, direction, radius).finished();
}

Eigen::Matrix<double, 8, 1> Cone::parameters() const {
  return (Eigen::Matrix<double, 8, 1>() << point, direction, radius, half_angle).finished();
}

Eigen::Vector3d Cone::apex() const { return point - direction * (radius / std::tan(half_angle)); }

double signed_distance(const Sphere& sphere, const Eigen::Vector3d& p) {
  return (p - sphere.centre).norm() - sphere.radius;
}

double signed_distance(const Plane& plane, const Eigen::Vector3d& p) { return plane.normal.dot(p - plane.point); }

double signed_distance(const Line& line, const Eigen::Vector3d& p) {
  return distance_to_axis(line.point, line.direction, p);
}

double radial_distance(const Circle& circle, const Eigen::Vector3d& p) {
  return distance_to_axis(circle.centre, circle.normal, p) - circle.radius;
}

double signed_distance(const Circle& circle, const Eigen::Vector3d& p) {
  const double radial = radial_distance(circle, p);
  return std::copysign(std::hypot(radial, circle.normal.dot(p - circle.centre)), radial);
}

double signed_distance(const Cylinder& cylinder, const Eigen::Vector3d& p) {
  return distance_to_axis(cylinder.point, cylinder.direction, p) - cylinder.radius;
}

double signed_distance(const Cone& cone, const Eigen::Vector3d& p) {
  const double across = distance_to_axis(cone.point, cone.direction, p) - cone.radius;
  return std::cos(cone.half_angle) * across - std::sin(cone.half_angle) * cone.direction.dot(p - cone.point);
}

}  // namespace artcal
