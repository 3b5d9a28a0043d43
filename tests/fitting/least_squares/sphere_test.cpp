#include <gtest/gtest.h>

#include "core/normal_vector.h"
#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

const Sphere truth = Shape<Sphere>::truth();

// A cap of a sphere about its pole, in rings; half_angle seen from the centre.
Eigen::Matrix3Xd cap(double radius, double half_angle, int rings, int around_ring) {
  Eigen::Matrix3Xd points(3, rings * around_ring);
  for (int i = 0; i < rings * around_ring; ++i) {
    const double polar = half_angle * (1 + i / around_ring) / rings;
    const double turn = 2.0 * pi * (i % around_ring) / around_ring + 0.3 * (i / around_ring);
    points.col(i) = around({3.0, 2.0, 1.0}, radius * std::sin(polar), turn, radius * std::cos(polar));
  }
  return points;
}

TEST(SphereFit, FourPoints) {
  const auto fitted = fit<Sphere>(Shape<Sphere>::points(4, 0.0));
  ASSERT_TRUE(fitted) << fitted.error().text();
  EXPECT_LT(apart(fitted->feature, truth).length, 1e-11);
  EXPECT_FALSE(fitted->noise.has_value());
}

TEST(SphereFit, ResidualsAreSignedAndFormIsTheirRange) {
  auto points = Shape<Sphere>::points(200, 0.0);
  points.col(5) += 0.01 * (points.col(5) - truth.centre).normalized();
  points.col(9) -= 0.02 * (points.col(9) - truth.centre).normalized();
  const auto fitted = fit<Sphere>(points);
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(fitted->residuals(5), 0.01, 1e-3);
  EXPECT_NEAR(fitted->residuals(9), -0.02, 1e-3);
  EXPECT_DOUBLE_EQ(fitted->form, fitted->residuals.maxCoeff() - fitted->residuals.minCoeff());
  EXPECT_NEAR(fitted->rms, std::sqrt(fitted->residuals.squaredNorm() / 200.0), 1e-15);
}

TEST(SphereFit, FixedRadiusFromASmallPatch) {
  FitOptions options;
  options.fixed_radius = 12.7;
  for (const int count : {3, 40}) {
    // One ring: two spheres hold it, and only the probe's side tells which.
    const Eigen::Matrix3Xd points = cap(12.7, 0.3, 1, count);
    EXPECT_EQ(fit<Sphere>(points, options).error().code, ErrorCode::NoSolution);
    FitOptions sided = options;
    sided.towards = a_direction;
    const auto fitted = fit<Sphere>(points, sided);
    ASSERT_TRUE(fitted) << fitted.error().text();
    EXPECT_LT((fitted->feature.centre - Eigen::Vector3d(3.0, 2.0, 1.0)).norm(), 1e-11);
    EXPECT_EQ(fitted->feature.radius, 12.7);
    EXPECT_EQ(fitted->degrees_of_freedom, count - 3);
    EXPECT_LT(fitted->residuals.cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(SphereFit, FixedRadiusFindsItsSideOfACap) {
  FitOptions options;
  options.fixed_radius = 12.7;
  const auto fitted = fit<Sphere>(cap(12.7, 0.2, 3, 8), options);
  ASSERT_TRUE(fitted) << fitted.error().text();
  EXPECT_LT((fitted->feature.centre - Eigen::Vector3d(3.0, 2.0, 1.0)).norm(), 1e-11);
}

TEST(SphereFit, FixedRadiusIsTheLeastSquaresAnswer) {
  FitOptions options;
  options.fixed_radius = 12.69;  // not what the points say: the residuals stay, the gradient vanishes
  const auto points = Shape<Sphere>::points(300, 0.01);
  const auto fitted = fit<Sphere>(points, options);
  ASSERT_TRUE(fitted);
  const Eigen::Matrix3Xd directions = (points.colwise() - fitted->feature.centre).colwise().normalized();
  EXPECT_LT((directions * fitted->residuals).norm(), 1e-12);
}

TEST(SphereFit, TenMetresFromSevenMillimetresOfSagitta) {
  const double radius = 10'000.0;
  const double half_angle = std::acos(1.0 - 7.0 / radius);
  const auto fitted = fit<Sphere>(cap(radius, half_angle, 4, 9));
  ASSERT_TRUE(fitted) << fitted.error().text();
  // One rounding of a coordinate, 1e-12 mm up there, is magnified by R/s = 1400.
  EXPECT_NEAR(fitted->feature.radius, radius, 5e-9);
  EXPECT_EQ(fitted->status, FitStatus::Converged);
}

TEST(SphereFit, FourCoplanarPointsAreNamed) {
  Eigen::Matrix3Xd square(3, 4);
  square << 10, -10, 0, 0, 0, 0, 10, -10, 5, 5, 5, 5;
  for (const Rigid& motion : {Rigid{}, a_motion()}) {
    const auto fitted = fit<Sphere>(moved(motion, square));
    ASSERT_FALSE(fitted);
    EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
    EXPECT_NE(fitted.error().message.find("plane"), std::string::npos) << fitted.error().message;
  }
}

TEST(SphereFit, OneCircleWithNoiseIsNamed) {
  const auto fitted = fit<Sphere>(Shape<Circle>::points(40, 0.001));
  ASSERT_FALSE(fitted);
  EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
}

TEST(SphereFit, APlaneIsNamed) {
  const auto fitted = fit<Sphere>(Shape<Plane>::points(40, 0.01));
  ASSERT_FALSE(fitted);
  EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
}

TEST(SphereFit, APatchTooSmallToTellTheRadiusIsNamed) {
  RandomStream random(1, "patch");
  Eigen::Matrix3Xd points = cap(12.7, 0.02, 3, 8);
  for (auto&& p : points.colwise()) {
    p += 0.005 * normal_vector(random);
  }
  const auto fitted = fit<Sphere>(points);
  ASSERT_FALSE(fitted) << fitted->feature.radius;
  EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
  EXPECT_NE(fitted.error().message.find("patch"), std::string::npos) << fitted.error().message;
}

TEST(SphereFit, ContradictoryOptionsAreUsage) {
  const auto points = Shape<Sphere>::points(30, 0.0);
  FitOptions options;
  options.fixed_radius = -1.0;
  EXPECT_EQ(fit<Sphere>(points, options).error().code, ErrorCode::Usage);
  options.fixed_radius = 12.7;
  EXPECT_EQ(fit<Plane>(points, options).error().code, ErrorCode::Usage);
  options.criterion = Criterion::MinimumZone;
  EXPECT_EQ(fit<Sphere>(points, options).error().code, ErrorCode::Usage);
  FitOptions noisy;
  noisy.noise = 0.0;
  EXPECT_EQ(fit<Sphere>(points, noisy).error().code, ErrorCode::Usage);
}

}  // namespace
}  // namespace artcal::test
