// Rails, columns and sliding arms: planted by 4 x 4 matrices; ranks by singular values of differences in numpy.
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/support/tracked.h"

namespace artcal {
namespace {

constexpr double right = std::numbers::pi / 2;

// The Stanford arm (Paul 1981): two revolute joints, a sliding one, three of the wrist.
Arm stanford() {
  Arm arm;
  arm.name = "Stanford";
  arm.joints = {{.d = 412.0, .alpha = -right},
                {.d = 154.0, .alpha = right},
                {.lowest = 300.0, .highest = 900.0, .type = JointType::Prismatic},
                {.alpha = -right},
                {.alpha = right},
                {.d = 263.0}};
  arm.probes.push_back({"tip", {30.0, 10.0, 50.0}, 0.0, false});
  return arm;
}

// A six-axis robot on a rail along its base's x axis (modified DH: the first joint's link turns z into x).
Arm on_a_rail() {
  Arm arm;
  arm.name = "on a rail";
  arm.convention = Convention::Modified;
  arm.joints = {{.alpha = right, .lowest = 0.0, .highest = 3000.0, .type = JointType::Prismatic},
                {.d = 400.0, .alpha = -right},
                {.a = 100.0, .alpha = -right},
                {.a = 600.0},
                {.a = 120.0, .d = 640.0, .alpha = -right},
                {.alpha = right},
                {.d = 80.0, .alpha = -right}};
  arm.probes.push_back({"tip", {30.0, 10.0, 50.0}, 0.0, false});
  return arm;
}

Arm off_nominal(const Arm& nominal, std::uint64_t seed) {
  RandomStream random(seed, "sliding");
  Arm arm = test::off_nominal(nominal, random);
  for (Joint& joint : arm.joints) {
    joint.beta += std::abs(std::sin(joint.alpha)) < 0.05 ? 1e-3 * random.normal() : 0.0;
  }
  return arm;
}

void comes_back(const Arm& nominal, int rank) {
  const test::Bound bound = test::tracked(off_nominal(nominal, 1), nominal, 300, 5e-3);
  IdentifyOptions options;
  options.leave_out = false;
  const Identification result = test::identified(bound, options);
  EXPECT_EQ(result.coupling.rank, rank) << nominal.name;
  EXPECT_NEAR(result.noise, 5e-3, 5e-4) << nominal.name;
  EXPECT_GT(result.before.overall.rms, 0.5) << nominal.name;
}

TEST(PrismaticJoint, ArmsWithOneAreIdentified) {
  comes_back(stanford(), 21);
  comes_back(on_a_rail(), 28);
}

}  // namespace
}  // namespace artcal
