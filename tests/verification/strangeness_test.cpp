#include "artefacts/verification/strangeness.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

// Tables of the F distribution: 5 % and 1 % points with (3, 10), (3, 20) and (3, 60).
TEST(Strangeness, LimitsAgreeWithTheTables) {
  EXPECT_NEAR(f3_limit(0.05, 10.0), 3.71, 0.04);
  EXPECT_NEAR(f3_limit(0.01, 10.0), 6.55, 0.10);
  EXPECT_NEAR(f3_limit(0.05, 20.0), 3.10, 0.03);
  EXPECT_NEAR(f3_limit(0.01, 20.0), 4.94, 0.05);
  EXPECT_NEAR(f3_limit(0.01, 60.0), 4.13, 0.04);
}

// How many of 2,000 sound sets have a point beyond the limit; `stretch` is how much worse z is than x and y.
double false_alarms(int points, double stretch) {
  int alarms = 0;
  constexpr int count = 2000;
  RandomStream random(4, "strangeness");
  Eigen::Matrix3Xd certified(3, points);
  for (int i = 0; i < points; ++i) {
    certified.col(i) = Eigen::Vector3d(100.0 * (i % 5), 100.0 * (i / 5), 10.0 * (i % 3));
  }
  for (int run = 0; run < count; ++run) {
    Eigen::Matrix3Xd measured = certified;
    for (int i = 0; i < points; ++i) {
      measured.col(i) += 1e-3 * Eigen::Vector3d(random.normal(), random.normal(), stretch * random.normal());
    }
    const Strangeness found = strangeness_of(measured, certified);
    alarms += found.distances.maxCoeff() > found.limit ? 1 : 0;
  }
  return static_cast<double>(alarms) / count;
}

TEST(Strangeness, SoundPointsAreSeldomStrange) {
  EXPECT_NEAR(false_alarms(25, 1.0), 0.01, 0.01);
  EXPECT_NEAR(false_alarms(25, 3.0), 0.01, 0.01);
  EXPECT_NEAR(false_alarms(9, 1.0), 0.01, 0.01);
  EXPECT_NEAR(false_alarms(6, 1.0), 0.01, 0.01);
}

TEST(Strangeness, ThreePointsTellNothing) {
  const Eigen::Matrix3Xd points = 100.0 * Eigen::Matrix3d::Identity();
  EXPECT_EQ(strangeness_of(points, points).limit, 0.0);
}

}  // namespace
}  // namespace artcal
