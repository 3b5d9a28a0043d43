#include "artefacts/virtual_probing/postures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace artcal {
namespace {

constexpr double usual_travel = 0.5;  // of a prismatic joint whose ends are not stated, of the arm's reach

}  // namespace

Eigen::VectorXd random_posture(const Arm& arm, RandomStream& random) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(arm.joints.size()));
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const Joint& joint = arm.joints[static_cast<std::size_t>(i)];
    if (joint.is_prismatic()) {
      const double travel = usual_travel * reach(arm);
      const double low = joint.lowest.value_or(joint.highest.value_or(0.5 * travel) - travel);
      q[i] = random.uniform(low, joint.highest.value_or(low + travel));
    } else {
      q[i] = random.uniform(-std::numbers::pi, std::numbers::pi);
    }
  }
  return q;
}

Eigen::Vector3d tip_at(const Arm& arm, int probe, const Eigen::VectorXd& q) {
  std::vector<double> sines(2 * static_cast<std::size_t>(q.size()));
  const std::span<const double> angles(q.data(), static_cast<std::size_t>(q.size()));
  joint_sines(angles, sines);
  return ForwardKinematics(arm, {}, probe).tip_in_base({sines, angles});
}

ReachWithJoints::ReachWithJoints(const Arm& arm, int probe)
    : kinematics_(arm, {}, probe),
      length_(reach(arm)),
      unit_(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(arm.joints.size()))),
      sines_(2 * arm.joints.size()),
      by_joints_(3, unit_.size()) {
  // A travel of a prismatic joint by the reach counts as one of a revolute joint by 1 rad.
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    unit_[static_cast<Eigen::Index>(i)] = arm.joints[i].is_prismatic() ? length_ : 1.0;
  }
}

std::optional<Eigen::VectorXd> ReachWithJoints::operator()(const Eigen::Vector3d& target_in_base, Eigen::VectorXd start,
                                                           double arm_temperature) {
  Eigen::VectorXd& q = start;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const std::span<const double> angles(q.data(), static_cast<std::size_t>(q.size()));
    joint_sines(angles, sines_);
    const Eigen::Vector3d miss =
        target_in_base - kinematics_.tip_by_joints({sines_, angles, arm_temperature}, by_joints_.data());
    if (miss.norm() <= 1e-13 * length_) {
      return q;
    }
    by_joints_ = by_joints_ * unit_.asDiagonal();
    // Damping that fades with the miss: steady far away, quadratic near.
    const double damping = 1e-3 * length_ * std::min(miss.norm(), length_) + 1e-16 * length_ * length_;
    const Eigen::Matrix3d normal = by_joints_ * by_joints_.transpose() + damping * Eigen::Matrix3d::Identity();
    const Eigen::VectorXd step = by_joints_.transpose() * normal.ldlt().solve(miss);
    const double largest = step.cwiseAbs().maxCoeff();
    q += (largest > 0.5 ? 0.5 / largest : 1.0) * unit_.cwiseProduct(step);
  }
  return std::nullopt;
}

std::optional<Eigen::VectorXd> reach_with_joints(const Arm& arm, int probe, const Eigen::Vector3d& target_in_base,
                                                 Eigen::VectorXd start, double arm_temperature) {
  return ReachWithJoints(arm, probe)(target_in_base, std::move(start), arm_temperature);
}

std::optional<Eigen::VectorXd> inverse_kinematics(const Arm& arm, int probe, const Eigen::Vector3d& place_in_base,
                                                  RandomStream& random, int starts) {
  for (int start = 0; start < starts; ++start) {
    if (auto q = reach_with_joints(arm, probe, place_in_base, random_posture(arm, random))) {
      return q;
    }
  }
  return std::nullopt;
}

}  // namespace artcal
