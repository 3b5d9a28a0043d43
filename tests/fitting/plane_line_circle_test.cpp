#include <gtest/gtest.h>

#include "core/normal_vector.h"
#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

using Covariance7 = Eigen::Matrix<double, 7, 7>;

Eigen::Matrix3Xd with_noise(Eigen::Matrix3Xd points, double noise) {
  RandomStream random(2, "noise");
  for (auto&& p : points.colwise()) {
    p += noise * normal_vector(random);
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

// A bore touched at heights that tilt the plane through the points: with the normal of the drawing the circle is the
// bore's, without it an oblique section's.
Eigen::Matrix3Xd touched_obliquely(double noise) {
  Eigen::Matrix3Xd points(3, 24);
  for (int i = 0; i < 24; ++i) {
    const double angle = 0.25 * i;
    points.col(i) = around({12.0, -7.0, 30.0}, 9.0, angle, 3.0 * std::cos(angle));
  }
  return with_noise(points, noise);
}

TEST(CircleFit, AKnownNormalIsTheCirclesOwn) {
  FitOptions options;
  options.circle_normal = 5.0 * a_direction;  // of any length
  const auto fitted = fit<Circle>(touched_obliquely(0.0), options);
  ASSERT_TRUE(fitted) << fitted.error().text();
  EXPECT_NEAR(fitted->feature.radius, 9.0, 1e-12);
  EXPECT_LT((fitted->feature.normal - a_direction).norm(), 1e-14);
  EXPECT_LT(off_axis(fitted->feature.centre, {12.0, -7.0, 30.0}, a_direction), 1e-12);
  EXPECT_LT(fitted->form, 1e-12);
  EXPECT_GT(fit<Circle>(touched_obliquely(0.0))->form, 0.1);
}

TEST(CircleFit, AKnownNormalInEveryCriterion) {
  for (const auto criterion : {Criterion::MinimumZone, Criterion::MinimumCircumscribed, Criterion::MaximumInscribed}) {
    FitOptions options;
    options.criterion = criterion;
    options.circle_normal = -a_direction;
    options.towards = a_direction;
    const auto fitted = fit<Circle>(touched_obliquely(0.0), options);
    ASSERT_TRUE(fitted) << fitted.error().text();
    EXPECT_NEAR(fitted->feature.radius, 9.0, 1e-9);
    EXPECT_GT(fitted->feature.normal.dot(a_direction), 0.999999);
  }
}

// Against points drawn again and again: no uncertainty of the normal, that of the centre in the plane and of the radius
// as they scatter.
TEST(CircleFit, TheCovarianceWithAKnownNormal) {
  constexpr double noise = 0.01;
  constexpr int draws = 400;
  FitOptions options;
  options.circle_normal = a_direction;
  options.noise = noise;
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  RandomStream random(3, "draws");
  const Eigen::Matrix3d frame = a_frame();
  Covariance7 covariance = Covariance7::Zero();
  for (int draw = 0; draw < draws; ++draw) {
    Eigen::Matrix3Xd points = touched_obliquely(0.0);
    for (auto&& p : points.colwise()) {
      p += noise * normal_vector(random);
    }
    const auto fitted = fit<Circle>(points, options);
    ASSERT_TRUE(fitted);
    const Eigen::Vector3d off = frame.transpose() * (fitted->feature.centre - Eigen::Vector3d(12.0, -7.0, 30.0));
    squares += Eigen::Vector3d(off.x() * off.x(), off.y() * off.y(), std::pow(fitted->feature.radius - 9.0, 2)) / draws;
    covariance = *fitted->covariance;
  }
  const Eigen::Matrix3d of_centre = frame.transpose() * covariance.topLeftCorner<3, 3>() * frame;
  EXPECT_NEAR(std::sqrt(squares.x() / of_centre(0, 0)), 1.0, 0.1);
  EXPECT_NEAR(std::sqrt(squares.y() / of_centre(1, 1)), 1.0, 0.1);
  EXPECT_NEAR(std::sqrt(squares.z() / covariance(6, 6)), 1.0, 0.1);
  EXPECT_LT((covariance.block<3, 3>(3, 3)).norm(), 1e-20);
}

TEST(CircleFit, AKnownNormalThatCannotBe) {
  FitOptions options;
  options.circle_normal = Eigen::Vector3d::Zero();
  EXPECT_EQ(fit<Circle>(touched_obliquely(0.0), options).error().code, ErrorCode::Usage);
  options.circle_normal = a_direction;
  EXPECT_EQ(fit<Plane>(Shape<Plane>::points(30, 0.0), options).error().code, ErrorCode::Usage);
  options.circle = CircleConvention::Spatial;
  EXPECT_EQ(fit<Circle>(touched_obliquely(0.0), options).error().code, ErrorCode::Usage);
  // Seen from the side, a circle is a line.
  FitOptions side;
  side.circle_normal = a_direction.unitOrthogonal();
  EXPECT_EQ(fit<Circle>(Shape<Circle>::points(30, 0.0), side).error().code, ErrorCode::NoSolution);
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
