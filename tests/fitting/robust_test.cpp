#include "fitting/robust.h"

#include <gtest/gtest.h>

#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

template <typename F>
class RobustFit : public testing::Test {};
using Features = testing::Types<Sphere, Plane, Line, Circle, Cylinder, Cone>;
TYPED_TEST_SUITE(RobustFit, Features);

TYPED_TEST(RobustFit, FindsExactlyThePointsThatWereMoved) {
  auto points = Shape<TypeParam>::points(60, 0.005);
  RandomStream random(9, "outliers");
  std::vector<int> moved_points;
  for (int i = 2; i < 60; i += 7) {
    // Moved until it is off the feature itself, not along it.
    const Eigen::Vector3d place = points.col(i);
    while (std::abs(signed_distance(Shape<TypeParam>::truth(), points.col(i))) < 0.2) {
      points.col(i) = place + random.uniform(0.3, 6.0) * random.direction();
    }
    moved_points.push_back(i);
  }
  const auto result = fit_robust<TypeParam>(points);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_EQ(result->outliers, moved_points);
  const Apart difference = apart(result->fitted.feature, Shape<TypeParam>::truth());
  EXPECT_LT(difference.length, 0.01) << difference;
  EXPECT_EQ(result->fitted.residuals.size(), 60);
  EXPECT_LT(result->fitted.form, 0.05);
}

TYPED_TEST(RobustFit, CleanPointsAreKeptAndGiveThePlainFit) {
  for (const double noise : {0.0, 0.005}) {
    const auto points = Shape<TypeParam>::points(60, noise, 1);  // none beyond 3.9 standard deviations
    const auto result = fit_robust<TypeParam>(points);
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_TRUE(result->outliers.empty());
    EXPECT_LT(apart(result->fitted.feature, fit<TypeParam>(points)->feature).length, 2e-12);
  }
}

TYPED_TEST(RobustFit, TheSameEveryTime) {
  auto points = Shape<TypeParam>::points(40, 0.01);
  points.col(4) += Eigen::Vector3d(3.0, 2.0, 1.0);
  const auto once = fit_robust<TypeParam>(points);
  const auto again = fit_robust<TypeParam>(points);
  EXPECT_EQ(once->outliers, again->outliers);
  EXPECT_EQ(once->fitted.feature.parameters(), again->fitted.feature.parameters());
}

TEST(RobustSphere, AStemOfFourTenthsOfThePoints) {
  Eigen::Matrix3Xd points = Shape<Sphere>::points(100, 0.005);
  for (int i = 60; i < 100; ++i) {
    points.col(i) = around(Shape<Sphere>::truth().centre, 2.0, 0.7 * i, -14.0 - 0.2 * (i - 60));
  }
  const auto result = fit_robust<Sphere>(points);
  ASSERT_TRUE(result);
  EXPECT_LT(apart(result->fitted.feature, Shape<Sphere>::truth()).length, 0.005);
  EXPECT_EQ(result->outliers.size(), 40u);
}

TEST(RobustSphere, TheListIsMadeAnewUntilItStands) {
  // A sphere through four of 25 points is a poor judge; the fit of those it kept is a better one.
  std::size_t lost = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    lost += fit_robust<Sphere>(Shape<Sphere>::points(25, 0.005, i))->outliers.size();
  }
  EXPECT_LE(lost, 5u);  // of 2500, where four standard deviations let one in 16,000 go
}

TEST(RobustSphere, GivenNoiseSetsTheLimit) {
  auto points = Shape<Sphere>::points(50, 0.001);
  const Eigen::Vector3d outwards = (points.col(7) - Shape<Sphere>::truth().centre).normalized();
  points.col(7) += 0.02 * outwards;
  FitOptions options;
  options.noise = 0.01;
  EXPECT_TRUE(fit_robust<Sphere>(points, options)->outliers.empty());
  options.noise = 0.001;
  EXPECT_EQ(fit_robust<Sphere>(points, options)->outliers, std::vector<int>{7});
}

TEST(RobustSphere, TipAndFixedRadius) {
  auto points = Shape<Sphere>::points(50, 0.001);
  points.col(7) += Eigen::Vector3d(1.0, 1.0, 1.0);
  FitOptions options;
  options.tip_radius = 3.0;
  options.fixed_radius = 9.7;
  const auto result = fit_robust<Sphere>(points, options);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_EQ(result->outliers, std::vector<int>{7});
  EXPECT_EQ(result->fitted.feature.radius, 9.7);
}

TEST(RobustSphere, BadRequestsAndBadPoints) {
  const auto points = Shape<Sphere>::points(20, 0.0);
  FitOptions zone;
  zone.criterion = Criterion::MinimumZone;
  EXPECT_EQ(fit_robust<Sphere>(points, zone).error().code, ErrorCode::Usage);
  RobustOptions robust;
  robust.share = 0.7;
  EXPECT_EQ(fit_robust<Sphere>(points, {}, robust).error().code, ErrorCode::Usage);
  EXPECT_EQ(fit_robust<Sphere>(points.leftCols(3)).error().code, ErrorCode::BadInput);
  EXPECT_EQ(fit_robust<Sphere>(Shape<Line>::points(20, 0.0)).error().code, ErrorCode::NoSolution);
}

}  // namespace
}  // namespace artcal::test
