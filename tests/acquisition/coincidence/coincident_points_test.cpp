#include "acquisition/coincidence/coincident_points.h"

#include <gmock/gmock.h>

#include "core/random.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

PointCloud cloud_of(const std::vector<Eigen::Vector3d>& points) {
  PointCloud cloud;
  cloud.points.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.points.col(static_cast<Eigen::Index>(i)) = points[i];
    cloud.rows.push_back(static_cast<int>(i));
  }
  return cloud;
}

const Eigen::Vector3d a(1, 2, 3), b(4, 5, 6), c(7, 8, 9.5), zero(0, 0, 0);

TEST(CoincidentPoints, EachPlaceCountsOnce) {
  PointCloud cloud = cloud_of({a, b, a, a, c, b});
  drop_coincident_points(cloud);
  EXPECT_THAT(cloud.rows, ElementsAre(0, 1, 4));
  EXPECT_EQ(cloud.points.col(2), c);
  EXPECT_THAT(cloud.warnings, ElementsAre(HasSubstr("3 of 6 points repeat an earlier one")));
  drop_coincident_points(cloud);
  EXPECT_EQ(cloud.warnings.size(), 1u);
}

TEST(CoincidentPoints, JointAnglesMakeADifference) {
  PointCloud cloud = cloud_of({a, a, a});
  cloud.joints.resize(1, 3);
  cloud.joints << 0.1, 0.2, 0.1;
  drop_coincident_points(cloud);
  EXPECT_THAT(cloud.rows, ElementsAre(0, 1));
  EXPECT_EQ(cloud.joints.cols(), 2);
}

TEST(CoincidentPoints, ZerosAreNoMeasurements) {
  PointCloud several = cloud_of({a, zero, b, zero, c});
  drop_coincident_points(several);
  EXPECT_THAT(several.rows, ElementsAre(0, 2, 4));
  EXPECT_THAT(several.warnings, ElementsAre(HasSubstr("2 of 5 points are at exactly 0 0 0")));
  // One alone, far off all others; and one that is the corner of what was scanned.
  const Eigen::Vector3d there(300, 200, 100);
  PointCloud one = cloud_of({there + a, zero, there + b});
  drop_coincident_points(one);
  EXPECT_THAT(one.rows, ElementsAre(0, 2));
  PointCloud corner = cloud_of({zero, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  drop_coincident_points(corner);
  EXPECT_THAT(corner.rows, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(corner.warnings, IsEmpty());
  PointCloud nothing = cloud_of({zero, zero});
  drop_coincident_points(nothing);
  EXPECT_EQ(nothing.rows.size(), 1u);
}

TEST(CoincidentPoints, FilesAreReadWithoutThem) {
  const testing::TemporaryFolder folder;
  const auto cloud = read_point_cloud(folder.write("p.xyz", "1 2 3\n4 5 6\n1 2 3\n0 0 0\n0 0 0\n7 8 9\n"), {});
  ASSERT_TRUE(cloud) << cloud.error().text();
  EXPECT_THAT(cloud->rows, ElementsAre(0, 1, 5));
  EXPECT_EQ(cloud->warnings.size(), 2u);
}

}  // namespace
}  // namespace artcal
