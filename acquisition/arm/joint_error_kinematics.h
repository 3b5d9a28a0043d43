#pragma once

#include <array>

#include "acquisition/arm/forward_kinematics.h"

namespace artcal {

/// What an arm with joint errors does at one reading.
struct Sweep::Posture {
  std::array<double, 2 * max_joints> sines;  ///< of the angles q', as JointSines
  std::array<double, max_joints> turns{};    ///< q' − q but for the sag, rad
  std::array<double, max_joints> torques{};  ///< N·mm
  std::array<double, max_joints> growth{};   ///< of the links
  double warmth = 0.0;                       ///< above the reference temperature, K

  /// For Sweep::walk().
  [[nodiscard]] auto grown() const {
    return [this](std::size_t link, double length) { return growth[link] * length; };
  }
};

}  // namespace artcal
