#include "acquisition/point_cloud/pcd/pcd_text.h"

#include <numbers>

#include <gtest/gtest.h>

#include "acquisition/point_cloud/point_cloud.h"
#include "core/random.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

TEST(PcdText, ReadsBackToItsDigits) {
  RandomStream random(1, "pcd text");
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::NullaryExpr(3, 20, [&] { return random.uniform(-2000.0, 2000.0); });
  const Eigen::MatrixXd joints = Eigen::MatrixXd::NullaryExpr(7, 20, [&] { return random.uniform(-7.0, 7.0); });
  const testing::TemporaryFolder folder;
  const auto cloud =
      read_point_cloud(folder.write("a.pcd", pcd_file_text(points, joints)), {1.0, std::numbers::pi / 180.0});
  ASSERT_TRUE(cloud) << cloud.error().text();
  ASSERT_EQ(cloud->joints.rows(), 7);
  EXPECT_LT((cloud->points - points).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((cloud->joints - joints).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_TRUE(cloud->warnings.empty());
}

TEST(PcdText, NeedsNoJoints) {
  const testing::TemporaryFolder folder;
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Identity(3, 3);
  const auto cloud = read_point_cloud(folder.write("a.pcd", pcd_file_text(points, {})), {});
  ASSERT_TRUE(cloud) << cloud.error().text();
  EXPECT_EQ(cloud->points, points);
  EXPECT_EQ(cloud->joints.rows(), 0);
}

}  // namespace
}  // namespace artcal
