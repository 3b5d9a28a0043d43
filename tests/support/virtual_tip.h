#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "artefacts/simulation/virtual_arm.h"
#include "tests/support/forward_kinematics.h"

/// Where the tip of a virtual arm is, from what its encoders read: the equations of virtual_arm.h the other
/// way round, with 4×4 matrices. Nothing here is taken from the simulation or the pass.
namespace artcal::testing {

/// Torque of the weight of all links further out about each axis, N·mm: Σ (centre − axis) × weight, each pair
/// of link and axis by itself.
inline std::vector<double> torques_of(const VirtualArm& arm, const std::vector<double>& rigid, int probe) {
  const ArmNumbers<double> numbers(arm.arm);
  const std::size_t n = rigid.size();
  std::vector<Eigen::Vector3d> points, axes;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t frames = arm.arm.convention == Convention::Standard ? i : i + 1;
    const auto frame = base_from_last(numbers, std::vector<double>(rigid.begin(), rigid.begin() + frames));
    points.emplace_back(frame.topRightCorner<3, 1>());
    if (arm.arm.convention == Convention::Modified) {
      // The axis of joint i has the frame's origin before the slide along it.
      points.back() -= arm.arm.joints[i].d * frame.block<3, 1>(0, 2);
    }
    axes.emplace_back(frame.block<3, 1>(0, 2));
  }
  points.push_back(tip_in_base(numbers, rigid, probe));
  std::vector<double> torques(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i; j < n; ++j) {
      const Eigen::Vector3d centre = (points[j] + points[j + 1]) / 2.0;
      const Eigen::Vector3d weight = arm.joints[j].mass * arm.arm.gravity_in_base;
      torques[i] += axes[i].dot((centre - points[i]).cross(weight));
    }
  }
  return torques;
}

/// The tip's centre in the base frame, mm, when the encoders read q (rad).
inline Eigen::Vector3d tip_of(const VirtualArm& arm, const Eigen::VectorXd& q, int probe = 0) {
  std::vector<double> rigid(q.begin(), q.end());
  for (int round = 0; round < 30; ++round) {
    const auto torques = torques_of(arm, rigid, probe);
    for (std::size_t i = 0; i < rigid.size(); ++i) {
      const VirtualJoint& joint = arm.joints[i];
      const double angle = q[static_cast<Eigen::Index>(i)];
      rigid[i] = angle + joint.eccentricity[0].amplitude * std::sin(angle + joint.eccentricity[0].phase) +
                 joint.eccentricity[1].amplitude * std::sin(2 * angle + joint.eccentricity[1].phase) +
                 arm.arm.joints[i].sign * joint.compliance * torques[i];
    }
  }
  const ArmNumbers<long double> numbers(arm.arm);
  return tip_in_base(numbers, std::vector<long double>(rigid.begin(), rigid.end()), probe).cast<double>();
}

}  // namespace artcal::testing
