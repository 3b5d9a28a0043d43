#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"

namespace artcal {

/// The torque of the weight of all links further out about each axis of an arm in one posture, and how it changes
/// when a part of the arm moves. A link's mass sits halfway between its own point and the next. On the stack.
struct WeighedChain {
  std::size_t joints = 0;
  std::array<Eigen::Vector3d, max_joints> axes;        ///< unit, in the base frame
  std::array<Eigen::Vector3d, max_joints + 1> points;  ///< a point on each axis, and the tip, mm
  std::array<Eigen::Vector3d, max_joints> weights;     ///< of the links, N

  using Torques = std::array<double, max_joints>;  ///< N·mm, in each axis' own sense; `joints` of them count
  [[nodiscard]] Torques torques() const;

  /// A small motion of all axes and points from `first` on: a turn (rad) about `at`, and a shift (mm).
  struct Motion {
    std::size_t first = 0;
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  };
  /// The change of the torques, to first order.
  [[nodiscard]] Torques change(const Motion& motion) const;
};

}  // namespace artcal
