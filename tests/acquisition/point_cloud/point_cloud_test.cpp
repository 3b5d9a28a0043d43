#include "acquisition/point_cloud/point_cloud.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/hash.h"
#include "core/units.h"
#include "tests/support/cloud_file.h"

namespace artcal {
namespace {

using testing::CloudFile;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Eigen::Matrix3Xd three = (Eigen::Matrix3Xd(3, 3) << 1.25, -4, 1e-3, 2, 5e2, 7, -3, 6, 0.1).finished();

class PointCloudText : public CloudFile {};

TEST_F(PointCloudText, BlanksTabsAndCommasSeparate) {
  for (const char* text :
       {"1.25 2 -3\n-4 5e2 6\n1e-3 7 0.1\n", "1.25\t2\t-3\r\n-4\t+5e2\t6\r\n1e-3\t7\t0.1\n",
        " 1.25,2 , -3\n\n-4,5e2,6\n1e-3,7,0.1\n", "# x y z\n1.25 2 -3 9 9\n// more\n-4 5e2 6 9 9\n1e-3 7 .1 9 9\n"}) {
    const auto cloud = read("p.xyz", text);
    ASSERT_TRUE(cloud) << cloud.error().text();
    EXPECT_EQ(cloud->points, three);
    EXPECT_THAT(cloud->rows, ElementsAre(0, 1, 2));
    EXPECT_EQ(cloud->joints.size(), 0);
    EXPECT_EQ(cloud->input.sha256, sha256(text));
    EXPECT_THAT(cloud->warnings, IsEmpty());
  }
}

TEST_F(PointCloudText, TheUnitIsTheCallers) {
  const auto cloud = read("p.xyz", "1 2 3\n4 5 6\n", {units::metre, {}});
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->points.col(1), Eigen::Vector3d(4000, 5000, 6000));
}

TEST_F(PointCloudText, AHeaderNamesTheColumns) {
  const auto cloud = read("p.csv", "\"Z\",q2,X,y,q1\n-3,180,1,2,90\n-6,0,4,5,-45\n", {1.0, units::degree});
  ASSERT_TRUE(cloud) << cloud.error().text();
  EXPECT_EQ(cloud->points, (Eigen::Matrix3Xd(3, 2) << 1, 4, 2, 5, -3, -6).finished());
  EXPECT_TRUE(cloud->joints.isApprox((Eigen::Matrix2d() << M_PI / 2, -M_PI / 4, M_PI, 0).finished(), 1e-15));
}

TEST_F(PointCloudText, JointsWithoutAUnitAreNotGuessed) {
  const auto cloud = read("p.csv", "x,y,z,q1\n1,2,3,90\n4,5,6,-45\n");
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->joints.size(), 0);
  EXPECT_THAT(cloud->warnings, ElementsAre(HasSubstr("joint angles in the file are not read")));
}

TEST_F(PointCloudText, NotANumberIsDroppedAndCounted) {
  const auto cloud = read("p.xyz", "nan nan nan\n1 2 3\n1 -inf 3\n4 5 6\nNaN 1 2\n");
  ASSERT_TRUE(cloud);
  EXPECT_THAT(cloud->rows, ElementsAre(1, 3));
  EXPECT_EQ(cloud->points.col(1), Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(cloud->dropped, 3u);
  EXPECT_THAT(cloud->warnings, ElementsAre("3 of 5 points are NaN or infinite and were dropped"));
  EXPECT_EQ(refusal("p.xyz", "nan 1 2\nnan 1 2\n"), "p.xyz: none of the 2 points is a number, all are NaN or infinite");
}

TEST_F(PointCloudText, DecimalCommasAreRefused) {
  EXPECT_EQ(refusal("p.xyz", "1,5 2,5 3,5\n"),
            "p.xyz:1: column 2: found \"5 2\", expected a number with a decimal point");
  EXPECT_THAT(refusal("p.xyz", "1,5\t2,5\t3,5\n"), HasSubstr("p.xyz:1: column 2: found"));
  EXPECT_THAT(refusal("p.xyz", "1 2 3\n4,5 6 7\n"), HasSubstr("p.xyz:2: column 1: found \"4,5\""));
}

TEST_F(PointCloudText, OddLinesAreNamed) {
  EXPECT_EQ(refusal("p.xyz", "1 2 3\n4 5\n"), "p.xyz:2: the line has 2 columns, expected 3 as in the lines before");
  EXPECT_EQ(refusal("p.xyz", "1 2\n4 5\n"), "p.xyz:1: the line has 2 columns, expected at least 3");
  EXPECT_EQ(refusal("p.xyz", "1 2 3\n# fine\n4 5 6x\n"),
            "p.xyz:3: column 3: found \"6x\", expected a number with a decimal point");
  EXPECT_THAT(refusal("p.xyz", "1 2 1e999\n"), HasSubstr("found \"1e999\""));
  EXPECT_THAT(refusal("p.csv", "1,2,3\n1,,3\n"), HasSubstr("p.csv:2: column 2: found nothing"));
  EXPECT_THAT(refusal("p.xyz", "1 2 3\r4 5 6\r"), HasSubstr("p.xyz:1: column 3: found"));
}

TEST_F(PointCloudText, HeadersThatDoNotTellXyzAreRefused) {
  EXPECT_EQ(refusal("p.csv", "a,b,c\n1,2,3\n"), "p.csv:1: there is no field x among a, b, c; expected x, y and z");
  EXPECT_EQ(refusal("p.csv", "x,y,z,X\n1,2,3,4\n"), "p.csv:1: the field x is there twice, expected it once");
  EXPECT_EQ(refusal("p.csv", "x,y,z,q1,q3\n1,2,3,4,5\n"),
            "p.csv:1: there is a field q3 but no q2; expected q1 … qn without a gap");
  EXPECT_EQ(refusal("p.csv", "x,y,z\n"), "p.csv: the file holds no points");
}

TEST_F(PointCloudText, NothingScannedIsRefused) {
  EXPECT_EQ(refusal("p.xyz", "# nothing\n\n"), "p.xyz: the file holds no points");
  EXPECT_EQ(refusal("p.xyz", ""), "p.xyz: the file is empty");
  EXPECT_EQ(refusal("p.xyz", "1 2 3\n1 2 3\n1 2 3\n"),
            "p.xyz: all 3 points are the same, (1, 2, 3) mm; nothing was scanned");
  EXPECT_TRUE(read("p.xyz", "1 2 3\n"));
}

TEST_F(PointCloudText, AnUnlikelySizeIsSaid) {
  const auto cloud = read("p.xyz", "0 0 0\n0.0125 0 0\n0 0.0125 0\n");
  ASSERT_TRUE(cloud);
  EXPECT_THAT(cloud->warnings, ElementsAre("the points span 0.0125 mm; is the unit right?"));
  EXPECT_THAT(read("p.xyz", "1 0 0\n1251 0 0\n", {units::metre, {}})->warnings,
              ElementsAre(HasSubstr("the points span 1.25e+06 mm")));
}

TEST_F(PointCloudText, OtherFormatsAreNamed) {
  EXPECT_THAT(refusal("p.las", "LASF\1\2"), HasSubstr("looks like LAS, which is not read; export it as PLY"));
  EXPECT_THAT(refusal("p.bin", std::string_view("\1\0\2", 3)), HasSubstr("zero bytes"));
  EXPECT_THAT(refusal("p.PCD", "1 2 3\n"), HasSubstr("the name ends in .pcd, but the file does not begin as such"));
  EXPECT_THAT(read_point_cloud("/nowhere/p.pcd", {}).error().text(), HasSubstr("there is no such file"));
}

}  // namespace
}  // namespace artcal
