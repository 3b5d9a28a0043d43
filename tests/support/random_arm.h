#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "acquisition/arm/arm.h"
#include "core/random.h"

namespace artcal::testing {

/// An arm of 1 to 9 joints with nothing regular about it, so that no term can hide behind a zero: both
/// conventions, joints that count backwards, Hayati angles, one to three probes on and off the axis.
/// Every third joint has the right angle, or the parallel axis, that real arms have.
inline Arm random_arm(RandomStream& random) {
  constexpr double pi = std::numbers::pi;
  Arm arm;
  arm.name = "random";
  arm.convention = random.uniform() < 0.5 ? Convention::Standard : Convention::Modified;
  arm.joints.resize(1 + random.bits() % 9);
  for (Joint& joint : arm.joints) {
    joint.a = random.uniform(-500.0, 500.0);
    joint.d = random.uniform(-500.0, 500.0);
    joint.theta = random.uniform(-pi, pi);
    joint.alpha = random.uniform(-pi, pi);
    if (random.uniform() < 1.0 / 3.0) {
      joint.alpha = random.uniform() < 0.5 ? 0.0 : pi / 2;
      joint.a = 0.0;
    }
    joint.sign = random.uniform() < 0.3 ? -1.0 : 1.0;
    joint.has_beta = random.uniform() < 0.3;
    joint.beta = joint.has_beta ? random.uniform(-0.5, 0.5) : 0.0;
  }
  arm.probes.resize(1 + random.bits() % 3);
  for (std::size_t i = 0; i < arm.probes.size(); ++i) {
    Probe& probe = arm.probes[i];
    probe.name = "probe " + std::to_string(i + 1);
    probe.radius = random.uniform(0.0, 10.0);
    probe.on_axis = random.uniform() < 0.4;
    const double z = random.uniform(20.0, 300.0);
    const double x = random.uniform(-100.0, 100.0);
    const double y = random.uniform(-100.0, 100.0);
    probe.tip_in_last = probe.on_axis ? Eigen::Vector3d(0.0, 0.0, z) : Eigen::Vector3d(x, y, z);
  }
  return arm;
}

/// Joint readings of any arm with `count` joints, rad.
inline std::vector<double> random_joints(RandomStream& random, std::size_t count) {
  std::vector<double> q(count);
  for (double& angle : q) {
    angle = random.uniform(-std::numbers::pi, std::numbers::pi);
  }
  return q;
}

}  // namespace artcal::testing
