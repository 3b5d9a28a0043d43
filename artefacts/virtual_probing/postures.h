#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"
#include "acquisition/arm/forward_kinematics.h"
#include "core/random.h"

namespace artcal {

/// Every joint anywhere on its circle, rad.
Eigen::VectorXd random_posture(const Arm& arm, RandomStream& random);

/// Where the tip is when the joints read q (rad), in the base frame, mm.
Eigen::Vector3d tip_at(const Arm& arm, int probe, const Eigen::VectorXd& q);

/// Joint angles (rad) that put the tip at a point of the base frame, found from `start` by damped
/// Gauss-Newton; the redundancy of the arm keeps the posture near the start. Nothing if the point cannot
/// be reached from there. The tip is within 1e-13 of the reach. `arm_temperature` as in JointReading.
std::optional<Eigen::VectorXd> reach_with_joints(const Arm& arm, int probe, const Eigen::Vector3d& target_in_base,
                                                 Eigen::VectorXd start,
                                                 double arm_temperature = std::numeric_limits<double>::quiet_NaN());

/// The same for many targets of one arm and probe, prepared once.
class ReachWithJoints {
 public:
  ReachWithJoints(const Arm& arm, int probe);
  std::optional<Eigen::VectorXd> operator()(const Eigen::Vector3d& target_in_base, Eigen::VectorXd start,
                                            double arm_temperature = std::numeric_limits<double>::quiet_NaN());

 private:
  ForwardKinematics kinematics_;
  double length_;
  Eigen::VectorXd unit_;  // of each joint
  std::vector<double> sines_;
  Eigen::Matrix3Xd by_joints_;
};

/// The same from random postures; nothing where as many `starts` lead nowhere.
std::optional<Eigen::VectorXd> inverse_kinematics(const Arm& arm, int probe, const Eigen::Vector3d& place_in_base,
                                                  RandomStream& random, int starts = 20);

}  // namespace artcal
