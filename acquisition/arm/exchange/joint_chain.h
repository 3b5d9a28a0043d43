#pragma once

#include <optional>
#include <string>
#include <vector>

#include "acquisition/arm/arm.h"
#include "core/error.h"
#include "core/rigid.h"

namespace artcal {

/// A joint as programs of robotics describe one: a frame that moves about or along any axis.
struct ChainJoint {
  std::string name;
  Rigid parent_from_joint;                                   ///< at a reading of zero, mm
  Eigen::Vector3d axis_in_joint = Eigen::Vector3d::UnitZ();  ///< unit; not looked at where the joint is fixed
  bool is_fixed = false;
  JointType type = JointType::Revolute;
  std::optional<double> lowest, highest;  ///< rad or mm
};

/// A chain from the base to a tip, outwards. Frames of fixed joints count as well.
struct JointChain {
  std::string name;
  std::vector<ChainJoint> joints;
  std::string tip;  ///< name of the tip
};

/// The arm in standard Denavit-Hartenberg parameters whose tip is where the chain's is in every posture, in the chain's
/// base frame: links between axes that are parallel to 5 degrees have Hayati's β and d = 0, the last joint has its tip
/// at lx, ly, lz. Every axis points as in the chain, so that signs are 1; that of the first may be -1.
///
/// Bad input, by the joint's name: the first moving axis is not the base's z axis (an arm's file has no transform
/// before it); no joint moves, or more than max_joints do. `base_on_first_axis`: the base frame is laid on the first
/// axis instead, and `base_from_arm`, where the arm's base is in the chain's, is given back.
struct ChainArm {
  Arm arm;
  Rigid base_from_arm;
  /// How the chain's tip is turned in the last joint's frame. An arm's file has the place of a tip and no orientation:
  /// no reading depends on it.
  Eigen::Matrix3d last_from_tip = Eigen::Matrix3d::Identity();
};
Expected<ChainArm> arm_of_chain(const JointChain& chain, bool base_on_first_axis = false);

/// Rz(yaw) · Ry(pitch) · Rx(roll), the fixed-axis angles of URDF.
Eigen::Matrix3d rotation_of_roll_pitch_yaw(const Eigen::Vector3d& roll_pitch_yaw);
/// The angles, rad; near pitch = ±90 degrees those of which the product is exact.
Eigen::Vector3d roll_pitch_yaw_of(const Eigen::Matrix3d& rotation);

}  // namespace artcal
