#include <gtest/gtest.h>

#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

Eigen::Matrix3Xd with_noise(Eigen::Matrix3Xd points, double noise) {
  RandomStream random(2, "noise");
  for (auto&& p : points.colwise()) {
    p += noise * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  }
  return points;
}

TEST(PlaneFit, PointsOnALineAreNamed) {
  for (const double noise : {0.0, 0.01}) {
    const auto fitted = fit<Plane>(Shape<Line>::points(30, noise));
    ASSERT_FALSE(fitted);
    EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
    EXPECT_NE(fitted.error().message.find("line"), std::string::npos) << fitted.error().message;
  }
}

TEST(PlaneFit, ThreePointsOnALineFarAwayAreNamed) {
  Eigen::Matrix3Xd points(3, 3);
  points << 10'000.1, 10'000.2, 10'000.3, 5'000.1, 5'000.2, 5'000.3, 1.1, 1.2, 1.3;
  EXPECT_EQ(fit<Plane>(points).error().code, ErrorCode::NoSolution);
}

TEST(PlaneFit, TowardsTurnsTheNormal) {
  FitOptions options;
  options.towards = -a_direction;
  const auto fitted = fit<Plane>(Shape<Plane>::points(30, 0.0), options);
  EXPECT_LT(fitted->feature.normal.dot(a_direction), -0.999);
  options.towards = Eigen::Vector3d::Zero();
  EXPECT_EQ(fit<Plane>(Shape<Plane>::points(30, 0.0), options).error().code, ErrorCode::Usage);
}

TEST(LineFit, FormIsTheDiameterOfTheCylinderAroundIt) {
  Eigen::Matrix3Xd points(3, 4);
  points << 0, 10, 20, 30, 0.01, -0.01, -0.01, 0.01, 0, 0, 0, 0;
  const auto fitted = fit<Line>(points);
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(fitted->form, 0.02, 1e-15);
  EXPECT_EQ(fitted->degrees_of_freedom, 4);
}

TEST(LineFit, ABallOfPointsIsNamed) {
  const auto fitted = fit<Line>(with_noise(Eigen::Matrix3Xd::Zero(3, 30), 1.0));
  ASSERT_FALSE(fitted);
  EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
}

TEST(CircleFit, TheConventionsDifferByWhatTheyMinimise) {
  const auto points = Shape<Circle>::points(12, 0.3, 4);
  FitOptions spatial;
  spatial.circle = CircleConvention::Spatial;
  const auto a = fit<Circle>(points);
  const auto b = fit<Circle>(points, spatial);
  ASSERT_TRUE(a && b);
  const auto cost = [&](const Circle& circle) {
    double sum = 0.0;
    for (const auto& p : points.colwise()) {
      sum += std::pow(signed_distance(circle, p), 2);
    }
    return sum;
  };
  EXPECT_LT(cost(b->feature), cost(a->feature));
  EXPECT_EQ(a->degrees_of_freedom, 9);
  EXPECT_EQ(b->degrees_of_freedom, 18);
  EXPECT_NEAR(b->residuals.squaredNorm(), cost(b->feature), 1e-12);
}

TEST(CircleFit, SpatialHasNoBetterNeighbour) {
  const auto points = Shape<Circle>::points(15, 0.3, 5);
  FitOptions spatial;
  spatial.circle = CircleConvention::Spatial;
  const Circle best = fit<Circle>(points, spatial)->feature;
  const auto cost = [&](const Circle& circle) {
    double sum = 0.0;
    for (const auto& p : points.colwise()) {
      sum += std::pow(signed_distance(circle, p), 2);
    }
    return sum;
  };
  RandomStream random(3, "neighbours");
  for (int i = 0; i < 200; ++i) {
    Circle other = best;
    other.centre += 1e-4 * random.direction();
    other.radius += 1e-4 * random.normal();
    other.normal = (other.normal + 1e-5 * random.direction()).normalized();
    EXPECT_GT(cost(other), cost(best));
  }
}

TEST(CircleFit, AShortArcOfTenMetres) {
  Eigen::Matrix3Xd points(3, 15);
  for (int i = 0; i < 15; ++i) {
    points.col(i) = around({1.0, 2.0, 3.0}, 10'000.0, 0.005 * (i - 7), 0.0);
  }
  for (const auto convention : {CircleConvention::Projected, CircleConvention::Spatial}) {
    FitOptions options;
    options.circle = convention;
    const auto fitted = fit<Circle>(points, options);
    ASSERT_TRUE(fitted) << fitted.error().text();
    EXPECT_NEAR(fitted->feature.radius, 10'000.0, 2e-8);
  }
}

TEST(CircleFit, PointsOnALineAreNamed) {
  for (const double noise : {0.0, 0.01}) {
    const auto fitted = fit<Circle>(Shape<Line>::points(30, noise));
    ASSERT_FALSE(fitted);
    EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
  }
}

}  // namespace
}  // namespace artcal::test
