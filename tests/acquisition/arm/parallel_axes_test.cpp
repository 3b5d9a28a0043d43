#include "acquisition/arm/parallel_axes.h"

#include <numbers>

#include <gtest/gtest.h>

#include "acquisition/arm/forward_kinematics.h"
#include "acquisition/arm/stretched_length.h"
#include "core/random.h"
#include "core/units.h"
#include "tests/support/arms.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/random_arm.h"
#include "tests/support/universal_robots.h"

namespace artcal {
namespace {

Eigen::Vector3d flange(const Arm& arm, std::vector<double> degrees) {
  for (double& q : degrees) q *= units::degree;
  std::vector<double> sines(2 * degrees.size());
  joint_sines(degrees, sines);
  return ForwardKinematics(arm, {}, 0).tip_in_base({sines, degrees});
}

// Computed from the published numbers by a forward kinematics in numpy (4 x 4 matrices), rounded to 1e-6 mm.
TEST(FactoryCalibrations, PutTheFlangeWhereTheirNumbersSay) {
  const Arm ur10e = test::calibrated_ur10e();
  const Arm ur5 = test::calibrated_ur5();
  for (const auto& [arm, q, at] :
       {std::tuple{ur10e, std::vector<double>(6, 0.0), Eigen::Vector3d(-1183.646806, -290.325590, 58.972829)},
        std::tuple{ur10e, std::vector<double>{0, -90, 90, -90, -90, 0},
                   Eigen::Vector3d(-691.185071, -173.345293, 676.123535)},
        std::tuple{ur10e, std::vector<double>{30, -60, 100, -130, -90, 45},
                   Eigen::Vector3d(-660.134373, -582.391175, 227.114216)},
        std::tuple{ur5, std::vector<double>(6, 0.0), Eigen::Vector3d(-816.304611, -194.275535, -5.464586)}}) {
    // d of 440 m leave a rounding of 1e-7 mm; that of the published numbers is added.
    EXPECT_LT((flange(arm, q) - at).norm(), 2e-6) << arm.name;
    EXPECT_LT((flange(with_hayati_angles(arm), q) - at).norm(), 2e-6) << arm.name;
  }
}

TEST(ParallelAxes, AreNamed) {
  EXPECT_EQ(parallel_axes(test::nominal_ur10e()), "axes 2 and 3 (0 deg), axes 3 and 4 (0 deg)");
  EXPECT_EQ(parallel_axes(test::calibrated_ur10e()), "axes 2 and 3 (0.08 deg), axes 3 and 4 (0.4 deg)");
  EXPECT_EQ(parallel_axes(test::gao_arm()), "");
  Arm modified = test::nominal_ur10e();
  modified.convention = Convention::Modified;  // alpha carries the index of the link before
  EXPECT_EQ(parallel_axes(modified), "axes 1 and 2 (0 deg), axes 2 and 3 (0 deg), axes 5 and 6 (0 deg)");
}

// The numbers that an identification in numpy with Hayati's angles gave for the tips of the calibrated arm.
TEST(HayatiAngles, DescribeTheAxesOfTheCalibratedArmWithoutLargeOffsets) {
  const Arm arm = with_hayati_angles(test::calibrated_ur10e());
  EXPECT_EQ(arm.joints[1].d, 0.0);
  EXPECT_EQ(arm.joints[2].d, 0.0);
  EXPECT_NEAR(arm.joints[3].d, 174.5122, 5e-5);
  EXPECT_NEAR(arm.joints[1].a, -612.5408, 5e-5);
  EXPECT_NEAR(arm.joints[2].a, -571.2529, 5e-5);
  EXPECT_NEAR(arm.joints[1].beta, 1.3935e-3, 5e-8);
  EXPECT_NEAR(arm.joints[2].beta, -0.5802e-3, 5e-8);
  EXPECT_NEAR(arm.joints[1].alpha, -0.044e-3, 5e-7);
  EXPECT_NEAR(arm.joints[2].alpha, 6.914e-3, 5e-7);
  EXPECT_TRUE(arm.joints[1].has_beta && arm.joints[2].has_beta && !arm.joints[0].has_beta);
}

// Whatever the convention, the direction of the axes and the signs: the same tips in every posture.
TEST(HayatiAngles, KeepEveryTip) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    RandomStream random(i, "parallel axes");
    Arm arm = test::nominal_ur10e();
    arm.convention = i % 2 == 0 ? Convention::Standard : Convention::Modified;
    arm.probes[0].tip_in_last = 200.0 * random.direction();
    for (Joint& joint : arm.joints) {
      joint = {.a = random.uniform(-400.0, 400.0),
               .d = random.uniform(-5e4, 5e4),
               .theta = random.uniform(-3.0, 3.0),
               .alpha = random.uniform(-0.08, 0.08) + (random.uniform() < 0.3 ? std::numbers::pi : 0.0),
               .beta = random.uniform(-0.02, 0.02),
               .sign = random.uniform() < 0.5 ? -1.0 : 1.0};
    }
    const Arm same = with_hayati_angles(arm);
    const auto q = testing::random_joints(random, 6);
    const Eigen::Vector3d tip = testing::tip_in_base(testing::ArmNumbers<double>(arm), q, 0);
    EXPECT_LT((testing::tip_in_base(testing::ArmNumbers<double>(same), q, 0) - tip).norm(), 1e-8) << i;
  }
}

TEST(HayatiAngles, LeaveOffsetsWithinTheReach) {
  Arm arm = test::nominal_ur10e();
  arm.joints[1].d = 174.15;
  arm.joints[3].d = 0.0;
  EXPECT_EQ(with_hayati_angles(arm).joints[1].d, 174.15);
}

// Where it reaches, not the sum of lengths: 885 m.
TEST(StretchedLength, OfAnArmWhoseOffsetsCancelIsThatOfTheArm) {
  EXPECT_NEAR(reach(test::calibrated_ur10e()), reach(with_hayati_angles(test::calibrated_ur10e())), 300.0);
  EXPECT_LT(reach(test::calibrated_ur10e()), 1700.0);
  EXPECT_LT(reach(test::calibrated_ur5()), 1600.0);
  Arm tilted = test::calibrated_ur10e();  // beyond what counts as nearly parallel, and over three axes
  tilted.joints[1] = {.a = 300.0, .d = 40000.0, .alpha = 0.12};
  tilted.joints[2] = {.a = 0.0, .d = -40000.0, .alpha = -0.12};
  EXPECT_LT(reach(tilted), 12000.0);
}

// No posture of any arm takes a tip farther from its first axis.
TEST(StretchedLength, BoundsEveryPosture) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    RandomStream random(i, "stretched length");
    const Arm arm = i < 20 ? test::calibrated_ur10e() : testing::random_arm(random);
    const double bound = stretched_length(arm);
    const testing::ArmNumbers<double> numbers(arm);
    const auto q = testing::random_joints(random, arm.joints.size());
    std::vector<double> sines(2 * q.size());
    joint_sines(q, sines);
    Eigen::Matrix3Xd directions(3, q.size()), points(3, q.size());
    ForwardKinematics(arm, {}, 0).axes_in_base({sines, q}, directions.data(), points.data());
    const Eigen::Vector3d from = testing::tip_in_base(numbers, q, 0) - points.col(0);
    EXPECT_LE((from - from.dot(directions.col(0)) * directions.col(0)).norm(), bound + 1e-9) << i;
  }
}

// The bound decides, without the shortest chain, for arms whose largest d is no longer than twice it.
TEST(StretchedLength, IsNotBelowItsLowerBound) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    RandomStream random(i, "bound of the stretched length");
    const Arm arm = testing::random_arm(random);
    EXPECT_LE(least_stretched_length(arm), stretched_length(arm) + 1e-9) << i;
  }
  for (const Arm& arm : {test::nominal_ur10e(), test::calibrated_ur10e()}) {
    EXPECT_GT(least_stretched_length(arm), 0.5 * stretched_length(arm)) << "or it settles little";
  }
}

}  // namespace
}  // namespace artcal
