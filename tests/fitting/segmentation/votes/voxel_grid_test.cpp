#include "fitting/segmentation/votes/voxel_grid.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/random.h"
#include "fitting/segmentation/spheres/direction_cells.h"

namespace artcal::segmentation {
namespace {

Eigen::Matrix3Xd some_points(int count, double size, const Eigen::Vector3d& offset) {
  RandomStream random(4, "points");
  Eigen::Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i) {
    points.col(i) = offset + size * Eigen::Vector3d{random.uniform(), random.uniform(), random.uniform()};
  }
  return points;
}

TEST(VoxelGrid, FindsWhatABruteSearchFinds) {
  for (const double edge : {0.3, 1.0, 40.0}) {
    const auto points = some_points(2000, 10.0, {-5000.0, 3.0, 1e4});
    const VoxelGrid grid = VoxelGrid::make(points, edge).value();
    for (const double radius : {0.1, 1.0, 3.0, 100.0}) {
      const Eigen::Vector3d centre = points.col(17) + Eigen::Vector3d(0.2, -0.3, 0.1);
      std::vector<int> expected;
      for (int i = 0; i < points.cols(); ++i) {
        if ((points.col(i) - centre).norm() < radius) expected.push_back(i);
      }
      EXPECT_EQ(grid.within(points, centre, radius), expected);
    }
  }
}

TEST(VoxelGrid, NeighbourhoodsAreSumsOverTouchingCubes) {
  const auto points = some_points(3000, 10.0, {0.0, 0.0, 0.0});
  const VoxelGrid grid = VoxelGrid::make(points, 1.3).value();
  const auto sums = grid.neighbourhoods();
  std::map<std::array<int, 3>, int> counts;
  const auto cube_of = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d offset = (p - grid.origin()) / 1.3;
    return std::array{static_cast<int>(std::floor(offset.x())), static_cast<int>(std::floor(offset.y())),
                      static_cast<int>(std::floor(offset.z()))};
  };
  for (const auto& p : points.colwise()) ++counts[cube_of(p)];
  ASSERT_EQ(grid.size(), counts.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const auto at = cube_of(grid.origin() + grid.moments(i).sum / grid.moments(i).count);
    int expected = 0;
    for (const auto& [cube, count] : counts) {
      const bool touches =
          std::abs(cube[0] - at[0]) <= 1 && std::abs(cube[1] - at[1]) <= 1 && std::abs(cube[2] - at[2]) <= 1;
      expected += touches ? count : 0;
    }
    EXPECT_EQ(sums[i].count, expected);
    EXPECT_EQ(grid.points_in(i).size(), static_cast<std::size_t>(grid.moments(i).count));
  }
}

TEST(VoxelGrid, CoarsenedIsWhatTwiceTheEdgeGives) {
  const auto points = some_points(3000, 10.0, {0.0, 0.0, 0.0});
  const VoxelGrid coarse = VoxelGrid::make(points, 0.7).value().coarsened();
  const VoxelGrid direct = VoxelGrid::make(points, 1.4).value();
  ASSERT_EQ(coarse.size(), direct.size());
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_EQ(coarse.moments(i).count, direct.moments(i).count);
    EXPECT_LT((coarse.moments(i).squares - direct.moments(i).squares).norm(), 1e-9);
  }
}

// A room of 4 km in cubes of 2 mm: 2e18 of them, far more than 32 bits count.
TEST(VoxelGrid, HugeRoomsAreCountedRight) {
  auto points = some_points(100, 1.0, {0.0, 0.0, 0.0});
  points.col(7) = Eigen::Vector3d::Constant(4e6);
  const VoxelGrid grid = VoxelGrid::make(points, 2.0).value();
  EXPECT_EQ(grid.size(), 2u);
  EXPECT_EQ(grid.within(points, points.col(7), 1.0), std::vector<int>{7});
  points.col(7) = Eigen::Vector3d::Constant(1e9);
  EXPECT_FALSE(VoxelGrid::make(points, 2.0));
}

// Cubes ascend with x fastest, the points of each ascend and are summed up in that order, to the last digit: in a room
// whose cubes and points go into one number, and in one where they do not.
TEST(VoxelGrid, IsThatOfAPlainSort) {
  for (const double far : {0.0, 4e6}) {
    auto points = some_points(200'000, 30.0, {-5.0, 3.0, 40.0});
    points.col(7) += Eigen::Vector3d::Constant(far);
    constexpr double edge = 2.0;
    const Eigen::Vector3d origin = points.rowwise().minCoeff();
    std::map<std::array<double, 3>, std::vector<std::uint32_t>> cubes;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Eigen::Vector3d at = ((points.col(i) - origin) / edge).array().floor();
      cubes[{at.z(), at.y(), at.x()}].push_back(static_cast<std::uint32_t>(i));
    }
    const VoxelGrid grid = VoxelGrid::make(points, edge).value();
    ASSERT_EQ(grid.size(), cubes.size());
    std::size_t cube = 0;
    for (const auto& [key, expected] : cubes) {
      const auto in_cube = grid.points_in(cube);
      ASSERT_TRUE(std::equal(in_cube.begin(), in_cube.end(), expected.begin(), expected.end())) << cube;
      Moments moments;
      for (const std::uint32_t i : expected) {
        moments.add(points.col(i) - origin);
      }
      EXPECT_EQ(grid.moments(cube).sum, moments.sum);
      EXPECT_EQ(grid.moments(cube).squares, moments.squares);
      ++cube;
    }
  }
}

TEST(VoxelGrid, FindsManyPointsInTheirOrder) {
  const auto points = some_points(50'000, 10.0, {0.0, 0.0, 0.0});
  const VoxelGrid grid = VoxelGrid::make(points, 1.0).value();
  const Eigen::Vector3d middle(5.0, 5.0, 5.0);
  for (const double radius : {0.5, 4.0, 20.0}) {
    std::vector<int> expected;
    for (int i = 0; i < points.cols(); ++i) {
      if ((points.col(i) - middle).squaredNorm() < radius * radius) expected.push_back(i);
    }
    EXPECT_EQ(grid.within(points, middle, radius), expected) << radius;
  }
}

TEST(DirectionCells, SharesAreAreas) {
  for (const int n : {1, 2, 5, 9}) {
    const DirectionCells cells(n);
    EXPECT_EQ(cells.size(), static_cast<std::size_t>(6 * n * n));
    RandomStream random(3, "directions");
    std::vector<int> hits(cells.size(), 0);
    constexpr int count = 200'000;
    for (int i = 0; i < count; ++i) ++hits[cells.cell_of(random.direction())];
    double all = 0.0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const double expected = count * cells.share(c);
      EXPECT_NEAR(hits[c], expected, 5.0 * std::sqrt(expected));
      all += cells.share(c);
    }
    EXPECT_NEAR(all, 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace artcal::segmentation
