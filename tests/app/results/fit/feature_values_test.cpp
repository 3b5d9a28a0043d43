#include "app/results/fit/feature_values.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "core/random.h"

namespace artcal {
namespace {

constexpr int trials = 300;
constexpr double noise = 0.002;

// A quarter of a cone about an oblique axis, apex at (10, -20, 30), half angle 25 degrees.
Eigen::Matrix3Xd cone_points() {
  const double half = 25.0 * M_PI / 180.0;
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  const Eigen::Vector3d across = axis.unitOrthogonal();
  const Eigen::Vector3d third = axis.cross(across);
  Eigen::Matrix3Xd points(3, 40);
  for (int i = 0; i < 40; ++i) {
    const double turn = 0.04 * i;
    const double along = 20.0 + (i * 7) % 11;
    points.col(i) = Eigen::Vector3d(10, -20, 30) +
                    along * (axis + std::tan(half) * (std::cos(turn) * across + std::sin(turn) * third));
  }
  return points;
}

// Each value's uncertainty against the spread of the same value over noisy repetitions.
TEST(FeatureValues, UncertaintiesOfAConeAreTheSpreadOfRepetitions) {
  const Eigen::Matrix3Xd truth = cone_points();
  FitOptions options;
  options.noise = noise;
  options.towards = Eigen::Vector3d(1, 2, 3);
  const auto exact = fit<Cone>(truth, options);
  ASSERT_TRUE(exact) << exact.error().text();
  const auto values = feature_values(*exact);
  ASSERT_EQ(values.size(), 11u);
  EXPECT_EQ(values[6].name, "diameter");
  EXPECT_EQ(values[7].name, "apex angle");
  EXPECT_NEAR(values[7].value, 50.0 * M_PI / 180.0, 1e-12);
  EXPECT_EQ(values[8].name, "apex x");
  EXPECT_NEAR(values[8].value, 10.0, 1e-9);
  EXPECT_NEAR(values[9].value, -20.0, 1e-9);
  EXPECT_NEAR(values[10].value, 30.0, 1e-9);

  RandomStream random(1, "feature values");
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(11);
  for (int trial = 0; trial < trials; ++trial) {
    Eigen::Matrix3Xd points = truth;
    for (double& coordinate : points.reshaped()) {
      coordinate += noise * random.normal();
    }
    const auto fitted = fit<Cone>(points, options);
    ASSERT_TRUE(fitted);
    const auto noisy = feature_values(*fitted);
    for (int i = 7; i < 11; ++i) {
      squares[i] += std::pow(noisy[static_cast<std::size_t>(i)].value - values[static_cast<std::size_t>(i)].value, 2);
    }
  }
  // Point and diameter are abreast of the centroid of the noisy points, which moves with them; angle and apex
  // are the feature's own.
  for (int i = 7; i < 11; ++i) {
    const FeatureValue& value = values[static_cast<std::size_t>(i)];
    ASSERT_TRUE(value.u);
    EXPECT_NEAR(std::sqrt(squares[i] / trials) / *value.u, 1.0, 0.15) << value.name;
  }
}

TEST(FeatureValues, NamesFollowTheParameters) {
  EXPECT_THAT(parameter_names<Sphere>(), ::testing::ElementsAre("centre x", "centre y", "centre z", "radius"));
  EXPECT_EQ(parameter_names<Plane>()[3], "normal x");
  EXPECT_EQ(parameter_names<Cylinder>()[5], "direction z");
  EXPECT_EQ(parameter_names<Circle>().size(), static_cast<std::size_t>(Circle::parameter_count));
  EXPECT_EQ(parameter_names<Line>().size(), static_cast<std::size_t>(Line::parameter_count));
  EXPECT_EQ(parameter_names<Cone>()[7], "half angle");
}

}  // namespace
}  // namespace artcal
