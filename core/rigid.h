#pragma once

#include <Eigen/Core>

namespace artcal {

/// A rigid motion a_from_b: takes coordinates in frame b to coordinates in frame a. Lengths in mm.
/// Named so that composition reads by cancellation: a_from_c = a_from_b * b_from_c.
struct Rigid {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  [[nodiscard]] Rigid inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }
};

inline Rigid operator*(const Rigid& a_from_b, const Rigid& b_from_c) {
  return {a_from_b.rotation * b_from_c.rotation, a_from_b.rotation * b_from_c.translation + a_from_b.translation};
}
inline Eigen::Vector3d operator*(const Rigid& a_from_b, const Eigen::Vector3d& point_in_b) {
  return a_from_b.rotation * point_in_b + a_from_b.translation;
}

}  // namespace artcal
