#include "acquisition/arm/gravity_torques.h"

#include <Eigen/Geometry>

namespace artcal {

// τi = zi · Σ (cj − pi) × wj over j ≥ i, as zi · (m − pi × f) with running sums from the tip inwards.
WeighedChain::Torques WeighedChain::torques() const {
  Torques torques{};
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t i = joints; i-- > 0;) {
    force += weights[i];
    moment += (0.5 * (points[i] + points[i + 1])).cross(weights[i]);
    torques[i] = axes[i].dot(moment - points[i].cross(force));
  }
  return torques;
}

WeighedChain::Torques WeighedChain::change(const Motion& motion) const {
  const auto moved = [&](std::size_t k) -> Eigen::Vector3d {
    return k < motion.first ? Eigen::Vector3d::Zero()
                            : Eigen::Vector3d(motion.turn.cross(points[k] - motion.at) + motion.shift);
  };
  Torques change{};
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment_change = Eigen::Vector3d::Zero();
  Eigen::Vector3d next = moved(joints);
  for (std::size_t i = joints; i-- > 0;) {
    const Eigen::Vector3d here = moved(i);
    force += weights[i];
    moment += (0.5 * (points[i] + points[i + 1])).cross(weights[i]);
    moment_change += (0.5 * (here + next)).cross(weights[i]);
    change[i] = axes[i].dot(moment_change - here.cross(force));
    if (i >= motion.first) {
      change[i] += motion.turn.cross(axes[i]).dot(moment - points[i].cross(force));
    }
    next = here;
  }
  return change;
}

}  // namespace artcal
