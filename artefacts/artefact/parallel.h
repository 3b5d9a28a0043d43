#pragma once

#include <Eigen/Geometry>

namespace artcal {

/// Sine of the largest angle at which two certified planes count as parallel, everywhere: 20 arc seconds. Between faces
/// 10 mm in radius the distance is then one to 1 µm, and so is what is lost where one normal stands for both.
inline constexpr double parallel_sine = 1e-4;

/// Whether planes with these unit normals are parallel, whichever way they face.
inline bool are_parallel(const Eigen::Vector3d& normal, const Eigen::Vector3d& other) {
  return normal.cross(other).norm() < parallel_sine;
}

}  // namespace artcal
