#include "acquisition/arm.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/random_arm.h"

namespace artcal {
namespace {

TEST(Reach, IsTheStretchedLengthBehindTheFirstAxis) {
  Arm arm;
  arm.joints = {{10.0, 300.0, 0.0, 0.0, 0.0, 1.0, false}, {-20.0, -65.0, 0.0, 0.0, 0.0, 1.0, false}};
  arm.probes = {{"short", {0.0, 0.0, 50.0}, 0.0, true}, {"long", {30.0, 0.0, 40.0 + 1e-9}, 0.0, false}};
  EXPECT_NEAR(reach(arm), 10.0 + 20.0 + 65.0 + 50.0, 1e-8);
  arm.convention = Convention::Modified;  // a of the first joint stands before its axis
  EXPECT_NEAR(reach(arm), 20.0 + 65.0 + 50.0, 1e-8);
}

// No pose takes a tip farther from the first axis than the reach.
TEST(Reach, BoundsEveryPose) {
  for (int i = 0; i < 200; ++i) {
    RandomStream random(1, "reach", static_cast<std::uint64_t>(i));
    const Arm arm = testing::random_arm(random);
    const auto q = testing::random_joints(random, arm.joints.size());
    const testing::ArmNumbers<double> numbers(arm);
    Arm base = arm;  // the point of the first axis where the swinging part begins
    base.joints.resize(1);
    base.joints[0].a = arm.convention == Convention::Standard ? 0.0 : arm.joints[0].a;
    base.probes[0].tip_in_last = Eigen::Vector3d::Zero();
    const Eigen::Vector3d foot = testing::tip_in_base(testing::ArmNumbers<double>(base), {q[0]}, 0);
    for (int probe = 0; probe < static_cast<int>(arm.probes.size()); ++probe) {
      EXPECT_LE((testing::tip_in_base(numbers, q, probe) - foot).norm(), reach(arm) * (1.0 + 1e-12));
    }
  }
}

TEST(ProbeIndex, FindsByName) {
  Arm arm;
  arm.probes.resize(2);
  arm.probes[0].name = "ball";
  arm.probes[1].name = "point";
  EXPECT_EQ(probe_index(arm, "ball"), 0);
  EXPECT_EQ(probe_index(arm, "point"), 1);
  EXPECT_EQ(probe_index(arm, "Ball"), -1);
  EXPECT_EQ(probe_index(Arm{}, "ball"), -1);
}

}  // namespace
}  // namespace artcal
