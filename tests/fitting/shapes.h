#pragma once

#include <cmath>
#include <numbers>
#include <ostream>

#include <Eigen/Geometry>

#include "core/normal_vector.h"
#include "core/random.h"
#include "core/rigid.h"
#include "fitting/fit.h"

// Points of known features, and how far two features are from each other.
namespace artcal::test {

constexpr double pi = std::numbers::pi;

template <typename F>
struct Shape;

/// Columns made one by one from `make(RandomStream&)`, each moved by normal noise in every coordinate.
template <typename Make>
Eigen::Matrix3Xd cloud_of(int count, double noise, std::uint64_t index, const Make& make) {
  RandomStream random(7, "shapes", index);
  Eigen::Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = make(random);
    points.col(i) = p + noise * normal_vector(random);
  }
  return points;
}

inline const Eigen::Vector3d a_direction = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();

/// A frame whose z axis is a_direction.
inline Eigen::Matrix3d a_frame() {
  Eigen::Matrix3d frame;
  frame.col(2) = a_direction;
  frame.col(0) = a_direction.unitOrthogonal();
  frame.col(1) = a_direction.cross(frame.col(0));
  return frame;
}

inline Eigen::Vector3d around(const Eigen::Vector3d& centre, double radius, double angle, double height) {
  return centre + a_frame() * Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), height);
}

template <>
struct Shape<Sphere> {
  static constexpr int fewest = 4;
  static Sphere truth() { return {{12.0, -7.0, 30.0}, 12.7}; }
  static Eigen::Matrix3Xd points(int count, double noise, std::uint64_t index = 0) {
    return cloud_of(count, noise, index,
                    [](RandomStream& r) -> Eigen::Vector3d { return truth().centre + truth().radius * r.direction(); });
  }
};

template <>
struct Shape<Plane> {
  static constexpr int fewest = 3;
  static Plane truth() { return {{12.0, -7.0, 30.0}, a_direction}; }
  static Eigen::Matrix3Xd points(int count, double noise, std::uint64_t index = 0) {
    return cloud_of(count, noise, index, [](RandomStream& r) -> Eigen::Vector3d {
      return truth().point + a_frame() * Eigen::Vector3d(r.uniform(-40.0, 40.0), r.uniform(-25.0, 25.0), 0.0);
    });
  }
};

template <>
struct Shape<Line> {
  static constexpr int fewest = 2;
  static Line truth() { return {{12.0, -7.0, 30.0}, a_direction}; }
  static Eigen::Matrix3Xd points(int count, double noise, std::uint64_t index = 0) {
    return cloud_of(count, noise, index, [](RandomStream& r) -> Eigen::Vector3d {
      return truth().point + r.uniform(-40.0, 40.0) * a_direction;
    });
  }
};

template <>
struct Shape<Circle> {
  static constexpr int fewest = 3;
  static Circle truth() { return {{12.0, -7.0, 30.0}, a_direction, 9.0}; }
  static Eigen::Matrix3Xd points(int count, double noise, std::uint64_t index = 0) {
    return cloud_of(count, noise, index, [](RandomStream& r) -> Eigen::Vector3d {
      return around(truth().centre, truth().radius, r.uniform(0.0, 2.0 * pi), 0.0);
    });
  }
};

template <>
struct Shape<Cylinder> {
  static constexpr int fewest = 5;
  static Cylinder truth() { return {{12.0, -7.0, 30.0}, a_direction, 9.0}; }
  static Eigen::Matrix3Xd points(int count, double noise, std::uint64_t index = 0) {
    return cloud_of(count, noise, index, [](RandomStream& r) -> Eigen::Vector3d {
      const double height = r.uniform(-20.0, 20.0);
      return around(truth().point, truth().radius, r.uniform(0.0, 2.0 * pi), height);
    });
  }
};

template <>
struct Shape<Cone> {
  static constexpr int fewest = 6;
  static Cone truth() { return {{12.0, -7.0, 30.0}, a_direction, 12.0, 0.35}; }
  static Eigen::Matrix3Xd points(int count, double noise, std::uint64_t index = 0) {
    return cloud_of(count, noise, index, [](RandomStream& r) -> Eigen::Vector3d {
      const double height = r.uniform(-20.0, 20.0);
      const double radius = truth().radius + height * std::tan(truth().half_angle);
      return around(truth().point, radius, r.uniform(0.0, 2.0 * pi), height);
    });
  }
};

/// How far apart two features are, mm and rad, whatever point of an axis or sign of a direction they use.
struct Apart {
  double length = 0.0;
  double angle = 0.0;
};

inline std::ostream& operator<<(std::ostream& out, const Apart& apart) {
  return out << apart.length << " mm, " << apart.angle << " rad";
}

inline double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

inline double off_axis(const Eigen::Vector3d& p, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
  return (p - point).cross(direction).norm();
}

inline Apart apart(const Sphere& a, const Sphere& b) {
  return {std::max((a.centre - b.centre).norm(), std::abs(a.radius - b.radius)), 0.0};
}
inline Apart apart(const Plane& a, const Plane& b) {
  return {std::abs((b.point - a.point).dot(a.normal)), angle_between(a.normal, b.normal)};
}
inline Apart apart(const Line& a, const Line& b) {
  return {off_axis(b.point, a.point, a.direction), angle_between(a.direction, b.direction)};
}
inline Apart apart(const Circle& a, const Circle& b) {
  return {std::max((a.centre - b.centre).norm(), std::abs(a.radius - b.radius)), angle_between(a.normal, b.normal)};
}
inline Apart apart(const Cylinder& a, const Cylinder& b) {
  return {std::max(off_axis(b.point, a.point, a.direction), std::abs(a.radius - b.radius)),
          angle_between(a.direction, b.direction)};
}
inline Apart apart(const Cone& a, const Cone& b) {
  const double radius_at_b = a.radius + std::tan(a.half_angle) * (b.point - a.point).dot(a.direction);
  return {std::max(off_axis(b.point, a.point, a.direction), std::abs(radius_at_b - b.radius)),
          std::max(angle_between(a.direction, b.direction), std::abs(a.half_angle - b.half_angle))};
}

inline Rigid a_motion() {
  RandomStream random(7, "motion");
  return {random.rotation(), {120.0, -340.0, 560.0}};
}

inline Sphere moved(const Rigid& m, const Sphere& f) { return {m * f.centre, f.radius}; }
inline Plane moved(const Rigid& m, const Plane& f) { return {m * f.point, m.rotation * f.normal}; }
inline Line moved(const Rigid& m, const Line& f) { return {m * f.point, m.rotation * f.direction}; }
inline Circle moved(const Rigid& m, const Circle& f) { return {m * f.centre, m.rotation * f.normal, f.radius}; }
inline Cylinder moved(const Rigid& m, const Cylinder& f) { return {m * f.point, m.rotation * f.direction, f.radius}; }
inline Cone moved(const Rigid& m, const Cone& f) {
  return {m * f.point, m.rotation * f.direction, f.radius, f.half_angle};
}

inline Sphere scaled(double s, const Sphere& f) { return {s * f.centre, s * f.radius}; }
inline Plane scaled(double s, const Plane& f) { return {s * f.point, f.normal}; }
inline Line scaled(double s, const Line& f) { return {s * f.point, f.direction}; }
inline Circle scaled(double s, const Circle& f) { return {s * f.centre, f.normal, s * f.radius}; }
inline Cylinder scaled(double s, const Cylinder& f) { return {s * f.point, f.direction, s * f.radius}; }
inline Cone scaled(double s, const Cone& f) { return {s * f.point, f.direction, s * f.radius, f.half_angle}; }

inline Eigen::Matrix3Xd moved(const Rigid& m, const Eigen::Matrix3Xd& points) {
  return (m.rotation * points).colwise() + m.translation;
}

}  // namespace artcal::test
