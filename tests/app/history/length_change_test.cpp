#include "app/history/length_change.h"

#include <cmath>

#include <gtest/gtest.h>

namespace artcal {
namespace {

// Two joints about z, links of 400 and 300 mm: the tip in the plane, without any of the program's kinematics.
Arm planar(double first = 400.0, double second = 300.0) {
  Arm arm;
  arm.joints.resize(2);
  arm.joints[0].a = first;
  arm.joints[1].a = second;
  arm.probes.resize(1);
  return arm;
}

TEST(LengthChange, OfTheSameArmIsNothing) {
  const auto change = length_change(planar(), planar());
  ASSERT_TRUE(change);
  EXPECT_EQ(change->maximum, 0.0);
}

TEST(LengthChange, HowTheBaseStandsDoesNotMatter) {
  Arm turned = planar();
  turned.joints[0].theta = 0.3;
  turned.joints[0].d = 50.0;
  EXPECT_LT(length_change(planar(), turned)->maximum, 1e-9);
}

TEST(LengthChange, OfAnArmThatGrewIsItsShareOfTheLengths) {
  const double expansion_factor = 1e-4;
  const auto change =
      length_change(planar(), planar(400.0 * (1.0 + expansion_factor), 300.0 * (1.0 + expansion_factor)));
  // Lengths of the plane's arm are at most twice its reach. The mean square of the distance of two random tips is
  // 2·(400² + 300²), for the directions of all four links are independent.
  EXPECT_LT(change->maximum, 1400.0 * expansion_factor);
  EXPECT_GT(change->maximum, 1200.0 * expansion_factor);
  EXPECT_NEAR(change->rms, expansion_factor * std::sqrt(2.0 * (400.0 * 400.0 + 300.0 * 300.0)), 0.05 * change->rms);
}

TEST(LengthChange, OfAnEncoderThatSlippedIsThatOfTheOuterLink) {
  Arm slipped = planar();
  slipped.joints[1].theta = 1e-4;
  // Two tips move by at most 2·300 mm times the angle against each other. The rms of 500 lengths is (250 ± 15) mm times
  // the angle: six draws by a Python script that shares nothing with this program.
  const auto change = length_change(planar(), slipped);
  EXPECT_LT(change->maximum, 2.0 * 300.0 * 1e-4 * 1.0001);
  EXPECT_GT(change->maximum, 2.0 * 300.0 * 0.95e-4);
  EXPECT_NEAR(change->rms, 250.0 * 1e-4, 25.0 * 1e-4);
}

TEST(LengthChange, OfArmsOfOtherJointsIsNotTold) {
  Arm longer = planar();
  longer.joints.resize(3);
  EXPECT_FALSE(length_change(planar(), longer));
}

}  // namespace
}  // namespace artcal
