// Minimum zone, minimum circumscribed, maximum inscribed.
#include <gtest/gtest.h>

#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

FitOptions by(Criterion criterion) {
  FitOptions options;
  options.criterion = criterion;
  return options;
}

Eigen::Matrix3Xd triangle() {
  Eigen::Matrix3Xd points(3, 3);
  points << 0, 30, 15, 0, 0, 15 * std::sqrt(3.0), 0, 0, 0;
  return points;
}

Eigen::Matrix3Xd tetrahedron() {
  Eigen::Matrix3Xd points(3, 4);
  points << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  return points * 30.0 / std::sqrt(8.0);
}

TEST(MinimumCircumscribed, TheTriangleAndTheTetrahedronOfSideThirty) {
  for (const Rigid& motion : {Rigid{}, a_motion()}) {
    const auto a = fit<Sphere>(moved(motion, triangle()), by(Criterion::MinimumCircumscribed));
    const auto b = fit<Sphere>(moved(motion, tetrahedron()), by(Criterion::MinimumCircumscribed));
    EXPECT_NEAR(2.0 * a->feature.radius, 60.0 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(2.0 * a->feature.radius, 34.641, 5e-4);
    EXPECT_NEAR(2.0 * b->feature.radius, 30.0 * std::sqrt(1.5), 1e-12);
    EXPECT_NEAR(2.0 * b->feature.radius, 36.742, 5e-4);
  }
}

TEST(MinimumCircumscribed, TwoPointsAreADiameter) {
  Eigen::Matrix3Xd points(3, 2);
  points << 1, 4, 2, 6, 3, 3;
  EXPECT_NEAR(fit<Sphere>(points, by(Criterion::MinimumCircumscribed))->feature.radius, 2.5, 1e-15);
}

TEST(MinimumCircumscribed, TenMetresOffCostsNothing) {
  const auto points = Shape<Sphere>::points(100, 0.05);
  const auto near = fit<Sphere>(points, by(Criterion::MinimumCircumscribed));
  const Rigid shift{Eigen::Matrix3d::Identity(), {10'000, -10'000, 10'000}};
  const auto far = fit<Sphere>(moved(shift, points), by(Criterion::MinimumCircumscribed));
  EXPECT_LT(apart(far->feature, moved(shift, near->feature)).length, 2e-11);
}

// Every criterion's optimum touches what it must, and no neighbour is better.
template <typename F>
void expect_no_better_neighbour(const Eigen::Matrix3Xd& points, Criterion criterion) {
  const auto fitted = fit<F>(points, by(criterion));
  ASSERT_TRUE(fitted) << fitted.error().text();
  const auto objective = [&](const F& f) {
    Eigen::VectorXd rho(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if constexpr (std::is_same_v<F, Circle>) {
        rho(i) = radial_distance(f, points.col(i)) + f.radius;
      } else {
        rho(i) = signed_distance(f, points.col(i)) + f.radius;
      }
    }
    switch (criterion) {
      case Criterion::MinimumZone: return rho.maxCoeff() - rho.minCoeff();
      case Criterion::MinimumCircumscribed: return rho.maxCoeff();
      default: return -rho.minCoeff();
    }
  };
  const double best = objective(fitted->feature);
  RandomStream random(5, "neighbours");
  for (int i = 0; i < 500; ++i) {
    F other = fitted->feature;
    const Eigen::Vector3d direction = random.direction();
    Eigen::Vector3d shift = std::pow(10.0, random.uniform(-9.0, -2.0)) * direction;
    if constexpr (std::is_same_v<F, Circle>) {
      shift -= other.normal * other.normal.dot(shift);
    }
    other.centre += shift;
    EXPECT_GE(objective(other), best - 2e-14);
  }
  const double low = fitted->residuals.minCoeff();
  const double high = fitted->residuals.maxCoeff();
  if (criterion == Criterion::MinimumZone) {
    EXPECT_NEAR(low, -high, 1e-12);
  } else {
    EXPECT_NEAR(criterion == Criterion::MinimumCircumscribed ? high : low, 0.0, 1e-12);
  }
  EXPECT_FALSE(fitted->covariance);
}

TEST(ExtremeFits, NoNeighbourIsBetter) {
  for (const auto criterion : {Criterion::MinimumZone, Criterion::MinimumCircumscribed, Criterion::MaximumInscribed}) {
    SCOPED_TRACE(static_cast<int>(criterion));
    expect_no_better_neighbour<Sphere>(Shape<Sphere>::points(100, 0.02), criterion);
    expect_no_better_neighbour<Circle>(Shape<Circle>::points(60, 0.02), criterion);
  }
}

// Four lobes of 10 µm, sampled densely on one side: the least-squares centre is off, and what it sees as
// extreme all lies in one lobe.
Eigen::Matrix3Xd crowded_lobes() {
  constexpr int count = 2000;
  Eigen::Matrix3Xd points(3, count + 8);
  for (int i = 0; i < count + 8; ++i) {
    const double even = 2.0 * pi * i / count;
    const double angle = i < count ? even + 0.95 * std::sin(even) : 0.25 * pi * (i - count);
    points.col(i) = around({1.0, 2.0, 3.0}, 20.0 + 0.01 * std::cos(4.0 * angle), angle, 0.0);
  }
  return points;
}

TEST(ExtremeFits, PointsThatTheFirstLookMissesAreFound) {
  const auto zone = fit<Circle>(crowded_lobes(), by(Criterion::MinimumZone));
  EXPECT_NEAR(zone->form, 0.02, 1e-12);
  EXPECT_LT((zone->feature.centre - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-10);
  EXPECT_NEAR(fit<Circle>(crowded_lobes(), by(Criterion::MaximumInscribed))->feature.radius, 19.99, 1e-12);
  EXPECT_NEAR(fit<Circle>(crowded_lobes(), by(Criterion::MinimumCircumscribed))->feature.radius, 20.01, 1e-12);
}

TEST(MinimumZone, AFourLobedCircleHasTheFormItWasMadeWith) {
  Eigen::Matrix3Xd points(3, 64);
  for (int i = 0; i < 64; ++i) {
    const double angle = 2.0 * pi * i / 64;
    points.col(i) = around({1.0, 2.0, 3.0}, 20.0 + 0.01 * std::cos(4.0 * angle), angle, 0.0);
  }
  const auto fitted = fit<Circle>(points, by(Criterion::MinimumZone));
  EXPECT_NEAR(fitted->form, 0.02, 1e-12);
  EXPECT_NEAR(fitted->feature.radius, 20.0, 1e-12);
}

TEST(MinimumZone, PlaneOfATetrahedronIsItsWidth) {
  // Between two opposite edges, not between a face and its corner: a/√2 against a·√(2/3).
  const auto fitted = fit<Plane>(tetrahedron(), by(Criterion::MinimumZone));
  EXPECT_NEAR(fitted->form, 30.0 / std::sqrt(2.0), 1e-12);
}

TEST(MinimumZone, PlaneIsNeverWiderThanLeastSquaresAndNoTiltHelps) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const auto points = Shape<Plane>::points(40, 0.05, i);
    const auto squares = fit<Plane>(points);
    const auto zone = fit<Plane>(points, by(Criterion::MinimumZone));
    ASSERT_TRUE(zone);
    EXPECT_LE(zone->form, squares->form + 1e-13);
    RandomStream random(i, "tilts");
    for (int k = 0; k < 200; ++k) {
      const Eigen::Vector3d direction = random.direction();
      const Eigen::Vector3d normal =
          (zone->feature.normal + std::pow(10.0, random.uniform(-8.0, -2.0)) * direction).normalized();
      const Eigen::RowVectorXd heights = normal.transpose() * (points.colwise() - zone->feature.point);
      EXPECT_GE(heights.maxCoeff() - heights.minCoeff(), zone->form - 1e-13);
    }
  }
}

TEST(MinimumZone, ExactPlanesHaveNone) {
  for (const int count : {3, 4, 50}) {
    const auto fitted = fit<Plane>(Shape<Plane>::points(count, 0.0), by(Criterion::MinimumZone));
    ASSERT_TRUE(fitted) << fitted.error().text();
    EXPECT_LT(fitted->form, 3e-14);
  }
  Eigen::Matrix3Xd grid(3, 9);  // exactly coplanar in doubles
  grid << 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 0, 0, 1, 1, 1, 2, 2, 2, 5, 5, 5, 5, 5, 5, 5, 5, 5;
  EXPECT_EQ(fit<Plane>(grid, by(Criterion::MinimumZone))->form, 0.0);
}

TEST(MaximumInscribed, APatchHoldsNoBallAndSaysSo) {
  auto points = Shape<Sphere>::points(400, 0.01);
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if ((points.col(i) - Shape<Sphere>::truth().centre).dot(a_direction) > 6.0) {
      points.col(kept++) = points.col(i);
    }
  }
  const auto fitted = fit<Sphere>(points.leftCols(kept), by(Criterion::MaximumInscribed));
  ASSERT_FALSE(fitted);
  EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
}

TEST(ExtremeFits, WhatAFeatureDoesNotHaveIsUsage) {
  const auto points = Shape<Cylinder>::points(30, 0.0);
  EXPECT_EQ(fit<Cylinder>(points, by(Criterion::MinimumZone)).error().code, ErrorCode::Usage);
  EXPECT_EQ(fit<Line>(points, by(Criterion::MaximumInscribed)).error().code, ErrorCode::Usage);
  EXPECT_EQ(fit<Plane>(points, by(Criterion::MinimumCircumscribed)).error().code, ErrorCode::Usage);
}

}  // namespace
}  // namespace artcal::test
