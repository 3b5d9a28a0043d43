#include "artefacts/verification/sphere_plate/ball_outliers.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

Eigen::Matrix3Xd grid(int points) {
  Eigen::Matrix3Xd certified(3, points);
  for (int i = 0; i < points; ++i) {
    certified.col(i) = Eigen::Vector3d(100.0 * (i % 3), 100.0 * (i / 3), 10.0 * (i % 2));
  }
  return certified;
}

// By F of scipy 1.10 at 0.01/n: √(3·6/4·F(3, 4)) for nine balls by direction, √(3·F(3, 15)) for eight and √(3·F(3, 3))
// for four with one scatter for all.
TEST(BallOutlierTest, LimitsOfSmallPlatesAreFishers) {
  EXPECT_NEAR(studentised_residuals(grid(9), grid(9)).limit, 15.474634483, 1e-6);
  EXPECT_NEAR(studentised_residuals(grid(8), grid(8)).limit, 5.167794617, 1e-6);
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
      measured.col(i) += 1e-3 * Eigen::Vector3d{random.normal(), random.normal(), stretch * random.normal()};
    }
    const BallOutlierTest found = studentised_residuals(measured, certified);
    alarms += found.distances.maxCoeff() > found.limit ? 1 : 0;
  }
  return static_cast<double>(alarms) / count;
}

// 1 % of 2,000 sets: 20 ± 4.5. Bonferroni's bound is reached from below, more so where the points hang together.
TEST(BallOutlierTest, SoundPointsAreSeldomStrangeButNotNever) {
  for (const auto& [points, stretch] : {std::pair{25, 1.0}, {25, 3.0}, {9, 1.0}, {8, 1.0}, {6, 1.0}, {4, 1.0}}) {
    const double alarms = false_alarms(points, stretch);
    EXPECT_LT(alarms, 0.019) << points << " points, z " << stretch << " times worse";
    EXPECT_GT(alarms, 0.002) << points << " points, z " << stretch << " times worse";
  }
}

TEST(BallOutlierTest, ThreePointsTellNothing) {
  const Eigen::Matrix3Xd points = 100.0 * Eigen::Matrix3d::Identity();
  EXPECT_EQ(studentised_residuals(points, points).limit, 0.0);
}

}  // namespace
}  // namespace artcal
