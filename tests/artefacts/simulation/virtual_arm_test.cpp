#include "artefacts/simulation/virtual_arm.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/units.h"
#include "tests/support/plans.h"
#include "tests/support/random_arm.h"
#include "tests/support/virtual_tip.h"

namespace artcal {
namespace {

TEST(VirtualArm, EccentricityIsWhatTheFieldSays) {
  // 10 µm on a grating of 60 mm: 412.5 · 10 / 60 = 68.75 arc seconds.
  EXPECT_NEAR(eccentricity_amplitude(0.010, 60.0) / units::arcsecond, 68.75, 0.01);
}

TEST(VirtualArm, EncoderErrorHasTwoHarmonics) {
  VirtualJoint joint;
  joint.eccentricity = {{{1e-4, 0.0}, {2e-5, std::numbers::pi / 2}}};
  EXPECT_NEAR(encoder_error(joint, 0.0), 2e-5, 1e-18);
  EXPECT_NEAR(encoder_error(joint, std::numbers::pi / 2), 1e-4 - 2e-5, 1e-18);
  EXPECT_NEAR(encoder_error(joint, std::numbers::pi), 2e-5, 1e-18);
}

// A beam of one metre, level, on a hinge whose axis is level: 2 kg halfway are 9.80665 N·m, and a
// compliance of 10 arcsec/(N·m) lets it sag by 98.07 arc seconds.
TEST(VirtualArm, ALevelBeamSags) {
  VirtualArm arm;
  Joint hinge;
  hinge.alpha = 0.0;
  arm.arm.joints = {{.a = 0, .d = 0, .theta = 0, .alpha = std::numbers::pi / 2}, {.a = 0, .d = 0}};
  arm.arm.probes.resize(1);
  arm.arm.probes[0].tip_in_last = {1000.0, 0.0, 0.0};
  arm.joints.resize(2);
  arm.joints[1].mass = 2.0;
  arm.joints[1].compliance = 10.0 * units::arcsecond / 1e3;
  const Eigen::Vector2d level(0.3, 0.0);
  const Eigen::VectorXd torques = gravity_torques(arm, 0, level);
  EXPECT_NEAR(torques[0], 0.0, 1e-9);
  EXPECT_NEAR(std::abs(torques[1]), 2.0 * 9.80665 * 500.0, 1e-9);
  // Level in truth: the encoder, which does not see the sag, reads more than zero (z up is its sense).
  EXPECT_NEAR(readings_of(arm, 0, level)[1] / units::arcsecond, 98.0665, 1e-9);
}

// Random arms of both conventions, off-axis tips, joints that count backwards.
TEST(VirtualArm, ReadingsLeadBackToWhereTheTipIs) {
  RandomStream random(1, "virtual arm");
  for (int trial = 0; trial < 200; ++trial) {
    VirtualArm arm;
    arm.arm = testing::random_arm(random);
    arm.joints.resize(arm.arm.joints.size());
    testing::spoil(arm);
    arm.arm.gravity_in_base = 9.80665 * random.direction();
    const auto rigid = testing::random_joints(random, arm.joints.size());
    const int probe = static_cast<int>(arm.arm.probes.size()) - 1;
    const Eigen::VectorXd q =
        readings_of(arm, probe, Eigen::VectorXd::Map(rigid.data(), static_cast<Eigen::Index>(rigid.size())));
    const Eigen::Vector3d there = testing::tip_in_base(testing::ArmNumbers<double>(arm.arm), rigid, probe);
    EXPECT_LT((testing::tip_of(arm, q, probe) - there).norm(), 1e-9) << trial;
  }
}

}  // namespace
}  // namespace artcal
