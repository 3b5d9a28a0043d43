#pragma once

#include <filesystem>

#include "acquisition/arm/exchange/joint_chain.h"

namespace artcal {

/// Reads a Universal Robots kinematics file (`kinematics:` with shoulder, upper_arm, forearm, wrist_1, wrist_2,
/// wrist_3, each x, y, z in m and roll, pitch, yaw in rad, as ur_calibration writes it): six revolute joints about the
/// z axes of these frames. The tip is the flange. Bad input: no YAML, a frame or a number that is not there, by its
/// name.
Expected<JointChain> read_calibration_yaml(const std::filesystem::path& path);

}  // namespace artcal
