#pragma once

#include <numbers>
#include <string>

#include "acquisition/arm/arm.h"

namespace artcal::test {

/// Gao, Lu, Yang 2013, Table 1: the nominal arm.
inline Arm gao_arm() {
  constexpr double right = std::numbers::pi / 2;
  Arm arm;
  arm.name = "Gao 2013, Table 1";
  for (const double d : {300.0, 65.5, 792.7, 65.5, 883.2, 0.0}) {
    arm.joints.push_back({.a = 0.0, .d = d, .theta = 0.0, .alpha = right});
  }
  Probe probe;
  probe.tip_in_last = {0.0, 0.0, 183.5};
  probe.on_axis = true;
  arm.probes.push_back(probe);
  return arm;
}

inline std::string example(const std::string& name) { return std::string(ARTCAL_SOURCE_DIR) + "/examples/" + name; }

}  // namespace artcal::test
