#include "acquisition/arm/arm.h"

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

// Along nearly parallel axes, d of hundreds of metres that cancel lead no farther than a few metres; each alone, or
// with axes across one another, they do.
TEST(Reach, CountsWhatIsLeftOfOffsetsThatCancel) {
  Arm arm;
  arm.joints = {{.d = 128.0, .alpha = 1.5708},
                {.a = -339.5, .d = 470769.03, .alpha = 0.0011},
                {.a = 255.9, .d = -699689.32, .alpha = 0.0022},
                {.a = 0.2, .d = 229083.97, .alpha = 1.5708},
                {.d = 115.8, .alpha = 1.5708},
                {}};
  arm.probes = {{"tip", {0.0, 0.0, 192.3}, 0.0, true}};
  const auto farthest = [](const Arm& posed) {
    const testing::ArmNumbers<double> numbers(posed);
    double distance = 0.0;
    for (int i = 0; i < 200; ++i) {
      RandomStream random(2, "reach", static_cast<std::uint64_t>(i));
      const Eigen::Vector3d tip = testing::tip_in_base(numbers, testing::random_joints(random, 6), 0);
      distance = std::max(distance, (tip - Eigen::Vector3d(0.0, 0.0, posed.joints.front().d)).norm());
    }
    return distance;
  };
  EXPECT_LE(farthest(arm), reach(arm));
  EXPECT_LT(reach(arm), 5000.0);
  for (const double alpha : {1.0, 3.1405}) {  // across one another, and pointing opposite ways: the first two add up
    arm.joints[1].alpha = alpha;
    EXPECT_GT(farthest(arm), 4e5);
    EXPECT_LE(farthest(arm), reach(arm));
  }
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
