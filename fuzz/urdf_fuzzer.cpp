#include "acquisition/arm/exchange/joint_chain.h"
#include "acquisition/arm/exchange/urdf_read.h"
#include "acquisition/arm/forward_kinematics.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const auto chain = read_urdf(fuzzing::folder().write("robot.urdf", fuzzing::bytes_of(data, size)), {});
  if (!chain) {
    fuzzing::require_sentence(chain.error());
    return 0;
  }
  const auto made = arm_of_chain(*chain);
  if (!made) {
    fuzzing::require_sentence(made.error());
    return 0;
  }
  // With all joints at zero the tip is where the chain's own frames put it.
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
  fuzzing::require((tip - base_from_tip.translation).norm() < 1e-9 * size_of_chain);
  return 0;
}
