#include "fitting/robust/distinct_points.h"

#include <gmock/gmock.h>

namespace artcal::fitting {
namespace {

std::vector<int> numbers(const DistinctPoints& distinct, int count) {
  std::vector<int> of;
  for (int i = 0; i < count; ++i) {
    of.push_back(distinct.of(static_cast<std::size_t>(i)));
  }
  return of;
}

TEST(DistinctPoints, AreNumberedByTheirFirstThatCounts) {
  Eigen::Matrix3Xd points(3, 6);
  points << 1, 2, 1, 3, 2, 1,  //
      0, 0, 0, 0, 0, 0,        //
      5, 5, 5, 5, 5, 5;
  const DistinctPoints all(points, {});
  EXPECT_THAT(numbers(all, 6), ::testing::ElementsAre(0, 1, 0, 2, 1, 0));
  EXPECT_EQ(all.points(), Eigen::Matrix3Xd(points(Eigen::all, {0, 1, 3})));
  EXPECT_EQ(all.weights().size(), 0);
  // The first of equal points has no weight: the next one stands for them.
  Eigen::VectorXd weights(6);
  weights << 0, 1, 4, 0, 2, 8;
  const DistinctPoints some(points, weights);
  EXPECT_THAT(numbers(some, 6), ::testing::ElementsAre(-1, 0, 1, -1, 0, 1));
  EXPECT_EQ(some.points(), Eigen::Matrix3Xd(points(Eigen::all, {1, 2})));
  EXPECT_EQ(some.weights(), Eigen::Vector2d(1, 4));
}

TEST(DistinctPoints, AreNotCopiedWhereAllDiffer) {
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Identity(3, 3);
  const Eigen::VectorXd weights = Eigen::Vector3d(1, 2, 3);
  const DistinctPoints distinct(points, weights);
  EXPECT_EQ(distinct.points().data(), points.data());
  EXPECT_THAT(numbers(distinct, 3), ::testing::ElementsAre(0, 1, 2));
  EXPECT_EQ(distinct.weights(), weights);
}

}  // namespace
}  // namespace artcal::fitting
