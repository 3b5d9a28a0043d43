#pragma once

#include "acquisition/arm/exchange/joint_chain.h"
#include "acquisition/arm/forward_kinematics.h"
#include "fuzz/check.h"

namespace artcal::fuzzing {

/// A chain that was read makes an arm, or says why not; with all joints at zero the arm's tip is where the chain's own
/// frames put it.
inline void check_chain(const Expected<JointChain>& chain) {
  if (!chain) {
    require_sentence(chain.error());
    return;
  }
  const auto made = arm_of_chain(*chain);
  if (!made) {
    require_sentence(made.error());
    return;
  }
  Rigid base_from_tip;
  double size_of_chain = 1.0;
  for (const ChainJoint& joint : chain->joints) {
    base_from_tip = base_from_tip * joint.parent_from_joint;
    size_of_chain += joint.parent_from_joint.translation.norm();
  }
  const std::vector<double> q(made->arm.joints.size(), 0.0);
  std::vector<double> sines(2 * q.size());
  joint_sines(q, sines);
  const Eigen::Vector3d tip = ForwardKinematics(made->arm, {}, 0).tip_in_base({sines, q});
  require((tip - base_from_tip.translation).norm() < 1e-9 * size_of_chain);
}

}  // namespace artcal::fuzzing
