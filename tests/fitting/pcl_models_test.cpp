// The points with which PCL tests its models, and the answers its tests expect (tests/reference/
// pcl-sample-consensus): rounded data with points that do not belong, which fit_robust must name.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/point_cloud/point_cloud.h"
#include "fitting/robust/robust.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Eigen::Matrix3Xd points_of(const char* name) {
  const auto cloud =
      read_point_cloud(std::filesystem::path(ARTCAL_SOURCE_DIR) / "tests/reference/pcl-sample-consensus" / name, {});
  return cloud ? cloud->points : Eigen::Matrix3Xd();
}

TEST(PclModels, Sphere) {
  FitOptions options;
  options.noise = 0.03 / 4.0;  // PCL's test calls what is within 0.03 an inlier; here that is four deviations
  const auto robust = fit_robust<Sphere>(points_of("sphere.xyz"), options);
  ASSERT_TRUE(robust) << robust.error().text();
  EXPECT_THAT(robust->outliers, ElementsAre(9));
  const Sphere& sphere = robust->fitted.feature;
  EXPECT_LT((sphere.centre / sphere.radius - Eigen::Vector3d(2, 2, 2)).norm(), 1e-2);
}

TEST(PclModels, SphereOfAScan) {
  const auto fitted = fit<Sphere>(points_of("normal-sphere.xyz"));
  ASSERT_TRUE(fitted) << fitted.error().text();
  EXPECT_LT((fitted->feature.centre - Eigen::Vector3d(0.0, 0.025, 1.0)).norm(), 1e-5);
  EXPECT_NEAR(fitted->feature.radius, 0.05, 1e-5);
}

TEST(PclModels, Cone) {
  const auto fitted = fit<Cone>(points_of("cone.xyz"));
  ASSERT_TRUE(fitted) << fitted.error().text();
  EXPECT_LT((fitted->feature.apex() - Eigen::Vector3d(0.0, 0.1, 1.0)).norm(), 1e-3);
  EXPECT_NEAR(fitted->feature.half_angle, 0.349066, 1e-3);
}

TEST(PclModels, Cylinder) {
  const auto fitted = fit<Cylinder>(points_of("cylinder.xyz"));
  ASSERT_TRUE(fitted) << fitted.error().text();
  const Cylinder& cylinder = fitted->feature;
  const Eigen::Vector3d off = cylinder.point - Eigen::Vector3d(-0.5, 1.7, cylinder.point.z());
  EXPECT_LT(off.norm(), 1e-3);
  EXPECT_NEAR(cylinder.direction.z(), 1.0, 1e-6);
  EXPECT_NEAR(cylinder.radius, 0.5, 1e-3);
}

TEST(PclModels, Circles) {
  const auto flat = fit_robust<Circle>(points_of("circle2d.xyz"));
  ASSERT_TRUE(flat) << flat.error().text();
  EXPECT_THAT(flat->outliers, ElementsAre(17));
  EXPECT_LT((flat->fitted.feature.centre - Eigen::Vector3d(3, -5, 0)).norm(), 1e-3);
  EXPECT_NEAR(flat->fitted.feature.radius, 1.0, 1e-3);
  const auto spatial = fit_robust<Circle>(points_of("circle3d.xyz"));
  ASSERT_TRUE(spatial) << spatial.error().text();
  EXPECT_THAT(spatial->outliers, ElementsAre(18, 19));
  EXPECT_LT((spatial->fitted.feature.centre - Eigen::Vector3d(1, 5, -3)).norm(), 1e-6);
  EXPECT_NEAR(std::abs(spatial->fitted.feature.normal.y()), 1.0, 1e-9);
  EXPECT_NEAR(spatial->fitted.feature.radius, 0.1, 1e-6);
}

}  // namespace
}  // namespace artcal
