#pragma once

#include <array>

#include "acquisition/arm/forward_kinematics.h"

namespace artcal {

/// What an arm with joint errors does at one reading.
struct ForwardKinematics::Posture {
  std::array<double, 2 * max_joints> sines;           ///< of the angles q', as JointReading
  std::array<double, max_joints> turns{};             ///< q' − q but for the sag, rad; of prismatic joints mm
  std::array<double, max_joints> travels{};           ///< q' of prismatic joints, mm
  std::array<double, max_joints> torques{};           ///< N·mm
  std::array<double, max_joints> expansion_factor{};  ///< of the links
  double temperature_offset = 0.0;                    ///< above the reference temperature, K

  /// For ForwardKinematics::walk().
  [[nodiscard]] auto grown() const {
    return [this](std::size_t link, double length) { return expansion_factor[link] * length; };
  }
};

}  // namespace artcal
