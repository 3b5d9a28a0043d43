#include <gtest/gtest.h>

#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

FitOptions tip(double radius, Side side) {
  FitOptions options;
  options.tip_radius = radius;
  options.side = side;
  return options;
}

TEST(TipRadius, OutsideIsTakenOffAndInsideIsAdded) {
  for (const double r : {0.5, 3.0}) {
    EXPECT_NEAR(fit<Sphere>(Shape<Sphere>::points(40, 0.0), tip(r, Side::Outside))->feature.radius, 12.7 - r, 1e-12);
    EXPECT_NEAR(fit<Sphere>(Shape<Sphere>::points(40, 0.0), tip(r, Side::Inside))->feature.radius, 12.7 + r, 1e-12);
    EXPECT_NEAR(fit<Circle>(Shape<Circle>::points(40, 0.0), tip(r, Side::Outside))->feature.radius, 9.0 - r, 1e-12);
    EXPECT_NEAR(fit<Cylinder>(Shape<Cylinder>::points(40, 0.0), tip(r, Side::Inside))->feature.radius, 9.0 + r, 1e-12);
  }
}

TEST(TipRadius, AConeOfTipCentresIsTheConeMovedSquareToItsSurface) {
  const Cone truth = Shape<Cone>::truth();
  const double r = 1.5;
  for (const Side side : {Side::Outside, Side::Inside}) {
    Eigen::Matrix3Xd centres = Shape<Cone>::points(50, 0.0);
    for (auto&& p : centres.colwise()) {
      const Eigen::Vector3d q = p - truth.point;
      const Eigen::Vector3d radial = (q - truth.direction * truth.direction.dot(q)).normalized();
      const Eigen::Vector3d normal = std::cos(truth.half_angle) * radial - std::sin(truth.half_angle) * truth.direction;
      p += (side == Side::Outside ? r : -r) * normal;
    }
    const Apart difference = apart(fit<Cone>(centres, tip(r, side))->feature, truth);
    EXPECT_LT(difference.length, 1e-11);
    EXPECT_LT(difference.angle, 1e-12);
  }
}

TEST(TipRadius, APlaneNeedsTheProbesSide) {
  const auto points = Shape<Plane>::points(20, 0.0);
  FitOptions options = tip(2.0, Side::Outside);
  EXPECT_EQ(fit<Plane>(points, options).error().code, ErrorCode::Usage);
  for (const double side : {1.0, -1.0}) {
    options.towards = side * a_direction;
    const auto fitted = fit<Plane>(points, options);
    ASSERT_TRUE(fitted);
    EXPECT_NEAR(a_direction.dot(fitted->feature.point - Shape<Plane>::truth().point), -2.0 * side, 1e-12);
  }
}

TEST(TipRadius, StandsOnTopOfAFixedRadius) {
  FitOptions options = tip(3.0, Side::Outside);
  options.fixed_radius = 9.7;
  const auto fitted = fit<Sphere>(Shape<Sphere>::points(40, 0.0), options);
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted->feature.radius, 9.7);
  EXPECT_LT(fitted->residuals.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TipRadius, MoreThanThereIsAndWhereThereIsNone) {
  EXPECT_EQ(fit<Sphere>(Shape<Sphere>::points(40, 0.0), tip(13.0, Side::Outside)).error().code, ErrorCode::NoSolution);
  EXPECT_EQ(fit<Line>(Shape<Line>::points(40, 0.0), tip(1.0, Side::Outside)).error().code, ErrorCode::Usage);
  EXPECT_EQ(fit<Sphere>(Shape<Sphere>::points(40, 0.0), tip(-1.0, Side::Outside)).error().code, ErrorCode::Usage);
}

}  // namespace
}  // namespace artcal::test
