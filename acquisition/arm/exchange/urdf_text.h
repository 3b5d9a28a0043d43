#pragma once

#include <string>

#include "acquisition/arm/arm.h"
#include "core/error.h"

namespace artcal {

/// The arm as a URDF: a joint for each of its own, and behind the last one a fixed joint to each probe's tip. Lengths
/// in m, with every digit.
///
/// Bad input, by the joint: what a URDF cannot express, which are errors of joints (harmonics, gain, coupling,
/// compliance, expansion), a mechanical coupling, and a prismatic joint whose ends are not stated.
/// `last_from_tip`: how the frames of the tips are turned in the last joint's, which an arm does not state.
Expected<std::string> urdf_text(const Arm& arm, const Eigen::Matrix3d& last_from_tip = Eigen::Matrix3d::Identity());

}  // namespace artcal
