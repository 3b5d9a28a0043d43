// Clouds that other programs wrote (tests/reference/pcl-clouds and cgal-clouds).

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/point_cloud/point_cloud.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::filesystem::path folder = std::filesystem::path(ARTCAL_SOURCE_DIR) / "tests/reference";

class PclDoubles : public ::testing::TestWithParam<std::string> {};

TEST_P(PclDoubles, EveryDigitIsThere) {
  const auto cloud = read_point_cloud(folder / "pcl-clouds" / GetParam(), {1.0, 1.0});
  ASSERT_TRUE(cloud) << cloud.error().text();
  ASSERT_EQ(cloud->points.cols(), 39);
  ASSERT_EQ(cloud->joints.rows(), 2);
  EXPECT_EQ(cloud->dropped, 1u);
  EXPECT_THAT(cloud->warnings, ElementsAre(HasSubstr("1 of 40 points are NaN")));
  for (Eigen::Index k = 0; k < 39; ++k) {
    const int i = cloud->rows[static_cast<std::size_t>(k)];
    EXPECT_EQ(i, k < 7 ? k : k + 1);
    EXPECT_EQ(cloud->points.col(k), Eigen::Vector3d(i / 3.0, i * i / 7.0 - 100.0, std::ldexp(1.0, -i) + 1000.0));
    EXPECT_EQ(cloud->joints.col(k), Eigen::Vector2d(-i / 11.0, i / 13.0));
  }
}

INSTANTIATE_TEST_SUITE_P(Files, PclDoubles,
                         ::testing::Values("double_ascii.pcd", "double_binary.pcd", "double_compressed.pcd",
                                           "double_ascii.ply", "double_binary.ply"),
                         [](const auto& test) {
                           std::string name = test.param;
                           name[name.find('.')] = '_';
                           return name;
                         });

class PclFloats : public ::testing::TestWithParam<std::string> {};

TEST_P(PclFloats, AreWhatWasWritten) {
  const auto cloud = read_point_cloud(folder / "pcl-clouds" / GetParam(), {});
  ASSERT_TRUE(cloud) << cloud.error().text();
  ASSERT_EQ(cloud->points.cols(), 40);
  EXPECT_THAT(cloud->warnings, IsEmpty());
  for (int i = 0; i < 40; ++i) {
    const auto f = static_cast<float>(i);
    const Eigen::Vector3d written(f / 3.0f, -f / 7.0f, f + 0.25f);
    const double bound = GetParam() == "float_ascii.pcd" ? 4e-6 : 0.0;
    EXPECT_LE((cloud->points.col(i) - written).cwiseAbs().maxCoeff(), bound) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, PclFloats,
                         ::testing::Values("float_ascii.pcd", "float_binary.pcd", "float_compressed.pcd"),
                         [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

// The numbers were taken out of the file by a program of its own (Python's struct).
TEST(CgalClouds, LittleEndianDoubles) {
  const auto cloud = read_point_cloud(folder / "cgal-clouds/circles.ply", {});
  ASSERT_TRUE(cloud) << cloud.error().text();
  ASSERT_EQ(cloud->points.cols(), 1101);
  EXPECT_EQ(cloud->points.col(0), Eigen::Vector3d(-0.39421442283839714, -0.6999221558404825, 0.0));
  EXPECT_EQ(cloud->points.col(1100), Eigen::Vector3d(0.8434192612020492, -0.5378861580596158, 0.0));
  EXPECT_NEAR(cloud->points.row(0).mean(), -0.21404586281965718, 1e-14);
  EXPECT_NEAR(cloud->points.row(1).mean(), 0.11746751433036567, 1e-14);
}

TEST(CgalClouds, TextWithCommentsFacesAndOtherProperties) {
  const auto example = read_point_cloud(folder / "cgal-clouds/example.ply", {});
  ASSERT_TRUE(example) << example.error().text();
  EXPECT_EQ(example->points, (Eigen::Matrix3d() << 0, 0, 0, 0, 0, 1, 0, 1, 0).finished());
  const auto sphere = read_point_cloud(folder / "cgal-clouds/sphere.ply", {});
  ASSERT_TRUE(sphere) << sphere.error().text();
  ASSERT_EQ(sphere->points.cols(), 162);
  EXPECT_LT((sphere->points.colwise().norm().array() - 0.5).abs().maxCoeff(), 5e-5);
  const auto table = read_point_cloud(folder / "cgal-clouds/sphere926.pwn", {});
  ASSERT_TRUE(table) << table.error().text();
  EXPECT_EQ(table->points.cols(), 926);
  EXPECT_LT((table->points.colwise().norm().array() - 10.0).abs().maxCoeff(), 2e-5);
}

}  // namespace
}  // namespace artcal
