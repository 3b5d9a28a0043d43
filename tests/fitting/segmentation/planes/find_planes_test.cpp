#include "fitting/segmentation/planes/find_planes.h"

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "core/random.h"
#include "fitting/segmentation/segment.h"

namespace artcal::testing {
namespace {

using ::testing::SizeIs;
using V = Eigen::Vector3d;

/// A rectangle of points in a plane somewhere in space.
struct Patch {
  V middle{300.0, -200.0, 1500.0};
  V normal = V(0.3, -0.2, 0.9).normalized();
  double length = 100.0, width = 60.0;
  int points = 2000;
  double noise = 0.0;
};

Eigen::Matrix3Xd points_of(const Patch& patch, std::uint64_t index = 0) {
  RandomStream random(31, "plane", index);
  const V u = patch.normal.unitOrthogonal();
  const V v = patch.normal.cross(u);
  Eigen::Matrix3Xd points(3, patch.points);
  for (auto&& p : points.colwise()) {
    const double off = patch.noise * random.normal();
    const double across = random.uniform(-0.5, 0.5) * patch.width;
    const double along = random.uniform(-0.5, 0.5) * patch.length;
    p = patch.middle + along * u + across * v + off * patch.normal;
  }
  return points;
}

ScanContents planes(int count) {
  ScanContents contents;
  contents.planes = count;
  return contents;
}

void expect_found(const Segmentation& found, const Patch& patch, double share) {
  ASSERT_THAT(found.planes, SizeIs(1)) << patch.points << " points, noise " << patch.noise;
  const FoundPlane& plane = found.planes.front();
  EXPECT_GE(static_cast<double>(plane.points.size()), share * patch.points) << patch.points << " " << patch.noise;
  const double height = std::abs(plane.fitted.feature.normal.dot(patch.middle - plane.fitted.feature.point));
  EXPECT_LT(height, 3.0 * patch.noise + 1e-9);
  EXPECT_LT(plane.fitted.feature.normal.cross(patch.normal).norm(), patch.noise / 5.0 + 1e-9);
}

// Simulations have none: the search's floats must not be the plane's noise.
TEST(FindPlanes, WithoutNoise) {
  for (const int points : {30, 100, 300, 2000, 20'000}) {
    for (const double noise : {0.0, 1e-7, 1e-4, 0.01}) {
      Patch patch;
      patch.points = points;
      patch.noise = noise;
      expect_found(segment(points_of(patch), planes(1)).value(), patch, 0.9);
    }
  }
}

TEST(FindPlanes, OnAxesAndOnAGrid) {
  Eigen::Matrix3Xd grid(3, 40 * 50);
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 50; ++j) {
      grid.col(50 * i + j) << 5.0 * i, 2.0 * j, 17.0;
    }
  }
  const auto found = segment(grid, planes(1)).value();
  ASSERT_THAT(found.planes, SizeIs(1));
  EXPECT_EQ(found.planes.front().points.size(), 2000u);
  EXPECT_NEAR(found.planes.front().fitted.feature.point.z(), 17.0, 1e-12);
}

TEST(FindPlanes, OfThirtyToAHundredPoints) {
  int found = 0;
  int tried = 0;
  for (std::uint64_t index = 0; index < 10; ++index) {
    for (const int points : {30, 40, 60, 100}) {
      Patch patch;
      patch.points = points;
      patch.noise = 0.02;
      patch.width = index % 2 == 0 ? 60.0 : 100.0;
      const auto result = segment(points_of(patch, index), planes(1)).value();
      ++tried;
      if (result.planes.size() == 1 && static_cast<double>(result.planes.front().points.size()) >= 0.8 * points) {
        ++found;
      }
    }
  }
  EXPECT_EQ(found, tried);
}

// A plane of few points beside one of many.
TEST(FindPlanes, OfFewPointsInAScanOfMany) {
  Patch large;
  large.points = 20'000;
  large.noise = 0.01;
  for (const int points : {40, 100, 400}) {
    Patch small;
    small.middle = large.middle + 80.0 * large.normal;
    small.points = points;
    small.noise = 0.01;
    Eigen::Matrix3Xd all(3, large.points + points);
    all << points_of(large), points_of(small, 1);
    const auto found = segment(all, planes(2)).value();
    ASSERT_THAT(found.planes, SizeIs(2)) << points;
    EXPECT_NEAR(large.normal.dot(found.planes[1].fitted.feature.point - large.middle), 80.0, 0.03);
  }
}

// What is round holds flat strips and spots, and is no plane.
TEST(FindPlanes, APipeAndABallHaveNone) {
  RandomStream random(5, "round");
  for (const double noise : {0.0, 0.02}) {
    Eigen::Matrix3Xd pipe(3, 6000), ball(3, 6000);
    for (Eigen::Index i = 0; i < 6000; ++i) {
      const double angle = random.uniform(0.0, 3.0);
      pipe.col(i) << (20.0 + noise * random.normal()) * std::cos(angle),
          (20.0 + noise * random.normal()) * std::sin(angle), random.uniform(0.0, 300.0);
      const Eigen::Vector3d direction = random.direction();
      ball.col(i) = (50.0 + noise * random.normal()) * direction;
    }
    EXPECT_THAT(segment(pipe, planes(1))->planes, SizeIs(0)) << noise;
    EXPECT_THAT(segment(ball, planes(1))->planes, SizeIs(0)) << noise;
  }
}

TEST(FindPlanes, ALumpHasNone) {
  RandomStream random(6, "lump");
  for (const int count : {60, 500, 5000}) {
    Eigen::Matrix3Xd lump(3, count);
    for (auto&& p : lump.colwise()) {
      p << random.uniform(0.0, 50.0), random.uniform(0.0, 50.0), random.uniform(0.0, 50.0);
    }
    EXPECT_THAT(segment(lump, planes(1))->planes, SizeIs(0)) << count;
  }
}

}  // namespace
}  // namespace artcal::testing
