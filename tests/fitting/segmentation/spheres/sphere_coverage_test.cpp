#include "fitting/segmentation/spheres/sphere_coverage.h"

#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal::segmentation {
namespace {

constexpr double pi = 3.14159265358979323846;

// Directions spread evenly over a cap of half angle t, over a part of a turn; its share of the sphere is
// (1 - cos t)/2 times that part.
Eigen::Matrix3Xd cap(double t, double part, int count, std::uint64_t index) {
  RandomStream random(21, "cap", index);
  Eigen::Matrix3Xd directions(3, count);
  for (int i = 0; i < count; ++i) {
    const double z = random.uniform(std::cos(t), 1.0);
    const double angle = 2.0 * pi * part * random.uniform();
    const double across = std::sqrt(1.0 - z * z);
    directions.col(i) << across * std::cos(angle), across * std::sin(angle), z;
  }
  return directions;
}

// Cells of a fixed number of points overstated 20 points three and a half times, 100 points by 70 %.
TEST(SphereCoverage, IsThatOfTheCap) {
  for (const double t : {0.4, 0.8, 1.2, 1.5}) {
    for (const double part : {1.0, 0.5}) {
      for (const auto& [count, off] :
           {std::pair(20, 0.3), {50, 0.2}, {100, 0.12}, {300, 0.08}, {1000, 0.1}, {20'000, 0.05}}) {
        const double share = 0.5 * (1.0 - std::cos(t)) * part;
        double mean = 0.0;
        constexpr int repeats = 5;
        for (int repeat = 0; repeat < repeats; ++repeat) {
          mean += sphere_coverage(cap(t, part, count, static_cast<std::uint64_t>(repeat))) / repeats;
        }
        EXPECT_NEAR(mean / share, 1.0, off) << t << " rad, " << part << ", " << count << " points";
      }
    }
  }
}

TEST(SphereCoverage, TheWholeSphereAndNothing) {
  EXPECT_NEAR(sphere_coverage(cap(pi, 1.0, 2000, 0)), 1.0, 0.01);
  EXPECT_EQ(sphere_coverage(Eigen::Matrix3Xd(3, 0)), 0.0);
  EXPECT_EQ(sphere_coverage(cap(1.0, 1.0, 3, 0)), 0.0);
}

TEST(SphereCoverage, RepeatedPointsSeeNoMore) {
  const Eigen::Matrix3Xd once = cap(0.8, 1.0, 60, 0);
  Eigen::Matrix3Xd often(3, 300);
  often << once, once, once, once, once;
  EXPECT_EQ(sphere_coverage(often), sphere_coverage(once));
}

TEST(SphereCoverage, ALineOfPointsSeesNothing) {
  Eigen::Matrix3Xd ring(3, 90);
  for (int i = 0; i < 90; ++i) {
    ring.col(i) << std::cos(0.07 * i), std::sin(0.07 * i), 0.5;
  }
  EXPECT_LT(sphere_coverage(ring), 0.03);
}

// Two caps far apart: what lies between them was not seen.
TEST(SphereCoverage, PartsAddUp) {
  Eigen::Matrix3Xd both(3, 600);
  both << cap(0.5, 1.0, 300, 0), -cap(0.5, 1.0, 300, 1);
  EXPECT_NEAR(sphere_coverage(both), 1.0 - std::cos(0.5), 0.1 * (1.0 - std::cos(0.5)));
}

// CGAL hands out facets in an order that follows from addresses: the sum of their areas had other last digits in the
// memory of another thread.
TEST(SphereCoverage, DoesNotDependOnWhereInMemoryItIsComputed) {
  for (std::uint64_t index = 0; index < 6; ++index) {
    const Eigen::Matrix3Xd directions = cap(1.3, 1.0, 8000, index);
    const double here = sphere_coverage(directions);
    std::vector<std::vector<char>> blocks;
    for (std::size_t i = 0; i < 400; ++i) {
      blocks.emplace_back(100 + 37 * (i % 29));
    }
    for (std::size_t i = 0; i < blocks.size(); i += 2) {
      blocks[i] = {};  // holes of many sizes
    }
    EXPECT_EQ(sphere_coverage(directions), here);
    double there = 0.0;
    std::thread([&] { there = sphere_coverage(directions); }).join();
    EXPECT_EQ(there, here);
  }
}

}  // namespace
}  // namespace artcal::segmentation
