#include "artefacts/simulation/virtual_arm.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "acquisition/arm/forward_kinematics.h"

namespace artcal {

bool VirtualArm::bends() const {
  return std::any_of(joints.begin(), joints.end(), [](const auto& joint) { return joint.compliance != 0.0; });
}

double encoder_error(const VirtualJoint& joint, double q) {
  const auto& [first, second] = joint.eccentricity;
  return first.amplitude * std::sin(q + first.phase) + second.amplitude * std::sin(2.0 * q + second.phase);
}

Eigen::VectorXd gravity_torques(const VirtualArm& arm, int probe, const Eigen::VectorXd& rigid_readings) {
  const Eigen::Index count = rigid_readings.size();
  std::vector<double> sines(2 * static_cast<std::size_t>(count));
  const std::span<const double> angles(rigid_readings.data(), static_cast<std::size_t>(count));
  joint_sines(angles, sines);
  Eigen::Matrix3Xd axes(3, count);
  Eigen::Matrix3Xd points(3, count + 1);
  points.col(count) = ForwardKinematics(arm.arm, {}, probe).axes_in_base({sines, angles}, axes.data(), points.data());
  Eigen::VectorXd torques(count);
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // weight of all further out, N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // of it about the origin of the base, N·mm
  for (Eigen::Index i = count - 1; i >= 0; --i) {
    const Eigen::Vector3d weight = arm.joints[i].mass * arm.arm.gravity_in_base;
    force += weight;
    moment += (0.5 * (points.col(i) + points.col(i + 1))).cross(weight);
    torques[i] = axes.col(i).dot(moment - points.col(i).cross(force));
  }
  return torques;
}

Eigen::VectorXd readings_of(const VirtualArm& arm, int probe, const Eigen::VectorXd& rigid_readings) {
  Eigen::VectorXd goal = rigid_readings;
  if (arm.bends()) {
    const Eigen::VectorXd torques = gravity_torques(arm, probe, rigid_readings);
    for (Eigen::Index i = 0; i < goal.size(); ++i) {
      goal[i] -= arm.arm.joints[i].sign * arm.joints[i].compliance * torques[i];
    }
  }
  Eigen::VectorXd q = goal;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    // The error changes by less than 0.03 of a step: ten are 1e-15 and beyond.
    for (int step = 0; step < 12; ++step) {
      q[i] = goal[i] - encoder_error(arm.joints[i], q[i]);
    }
  }
  return q;
}

}  // namespace artcal
