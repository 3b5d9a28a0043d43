// Planted planes, touched by a tip of 3 mm: their axis, on which side the tip was and where they are.
#include "identification/initial/plane_start.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace artcal {
namespace {

constexpr double tip_radius = 3.0;
const Eigen::Matrix3d base_from_block = (Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized())).matrix();
const Eigen::Vector3d place(400.0, -250.0, 180.0);

/// Faces at heights along the block's z axis, parallel, of which no certificate says which way they look.
struct Block {
  Constraints constraints;
  std::vector<Tips> faces;

  explicit Block(std::size_t count) { constraints.features.resize(count); }

  // Tips that touch the face at `height` from above (side 1) or below (-1), spread over `width` mm.
  void touch(double height, double side, double width = 60.0, int count = 12) {
    std::mt19937_64 engine(faces.size() + 7);
    std::uniform_real_distribution<double> spread(-width / 2, width / 2);
    FeatureConstraint& face = constraints.features[faces.size()];
    face.kind = OnPlane{};
    face.offset = 2 + static_cast<int>(faces.size());
    face.readings.resize(static_cast<std::size_t>(count));
    Eigen::Matrix3Xd centres(3, count), styluses(3, count);
    for (int k = 0; k < count; ++k) {
      centres.col(k) =
          place + base_from_block * Eigen::Vector3d(spread(engine), spread(engine), height + side * tip_radius);
      styluses.col(k) = base_from_block * Eigen::Vector3d(k % 2 == 0 ? 1.0 : -1.0, 0.0, 0.0);  // along the face
    }
    faces.push_back({&face, centres, Eigen::VectorXd::Constant(count, tip_radius), styluses});
  }
};

// Where a plane that was found lies above the block's origin, along the block's z axis.
double height_of(const GroupState& group, std::size_t face) {
  const Eigen::Vector3d axis = group.reference.rotation.col(2);
  const Eigen::Vector3d truth = base_from_block.col(2);
  EXPECT_NEAR(std::abs(axis.dot(truth)), 1.0, 1e-12);
  const Eigen::Vector3d on_plane = group.reference.origin + group.values[2 + static_cast<Eigen::Index>(face)] * axis;
  return truth.dot(on_plane - place);
}

double gap_between(const GroupState& group) { return height_of(group, 1) - height_of(group, 0); }

TEST(PlaneStart, ACertifiedDistanceTellsOuterFaces) {
  Block block(2);
  block.touch(0.0, -1.0);
  block.touch(50.0, 1.0);
  block.constraints.distances = {{0, 1, 50.0, 1e-3, true}};
  const auto found = estimate_planes(block.faces, block.constraints, "face \"A\"");
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_NEAR(height_of(*found, 0), 0.0, 1e-10);
  EXPECT_NEAR(height_of(*found, 1), 50.0, 1e-10);
}

TEST(PlaneStart, AndInnerFaces) {
  Block block(2);
  block.touch(0.0, 1.0);
  block.touch(50.0, -1.0);
  block.constraints.distances = {{0, 1, 50.0, 1e-3, true}};
  const auto found = estimate_planes(block.faces, block.constraints, "face \"A\"");
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_NEAR(gap_between(*found), 50.0, 1e-10);
}

// The tip's centres are 44, 50 or 56 mm apart; an arm that makes them 70 mm apart does not tell which.
TEST(PlaneStart, AnArmThatMissesTheDistanceDoesNotTellTheSide) {
  Block block(2);
  block.touch(0.0, -1.0);
  block.touch(64.0, 1.0);
  block.constraints.distances = {{0, 1, 50.0, 1e-3, true}};
  const auto found = estimate_planes(block.faces, block.constraints, "face \"A\"");
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::NoSolution);
  EXPECT_THAT(found.error().text(), testing::AllOf(testing::HasSubstr("face \"A\""), testing::HasSubstr("50 mm")));
}

// But the stylus does, which cannot come out of the material.
TEST(PlaneStart, UnlessTheStylusShowsIt) {
  Block block(2);
  block.touch(0.0, -1.0);
  block.touch(64.0, 1.0);
  block.constraints.distances = {{0, 1, 50.0, 1e-3, true}};
  for (std::size_t face = 0; face < 2; ++face) {
    const Eigen::Vector3d down = base_from_block * Eigen::Vector3d(0.3, 0.0, face == 0 ? 1.0 : -1.0).normalized();
    block.faces[face].styluses.colwise() = down;
  }
  const auto found = estimate_planes(block.faces, block.constraints, "face \"A\"");
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_NEAR(gap_between(*found), 64.0, 1e-10);
}

TEST(PlaneStart, ReadingsOnALineAreNoPlane) {
  Block block(1);
  block.touch(0.0, 1.0);
  for (Eigen::Index k = 0; k < block.faces[0].centres.cols(); ++k) {
    block.faces[0].centres.col(k) = place + static_cast<double>(k) * Eigen::Vector3d(1, 2, 3);
  }
  const auto found = estimate_planes(block.faces, block.constraints, "face \"A\"");
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().text(), testing::HasSubstr("not on a line"));
}

// A step gauge: heights 0, 20 and 60 mm, one face looking back. The faces share one place along the axis.
TEST(PlaneStart, AGaugePointsToWhereItsHeightsRise) {
  Block block(3);
  block.touch(0.0, 1.0, 8.0);
  block.touch(20.0, -1.0, 8.0);
  block.touch(60.0, 1.0, 8.0);
  const double heights[] = {0.0, 20.0, 60.0}, facing[] = {1.0, -1.0, 1.0};
  for (std::size_t face = 0; face < 3; ++face) {
    block.constraints.features[face].kind = OnPlane{{}, GaugeFace{facing[face], heights[face]}};
    block.constraints.features[face].offset = 2;
  }
  const auto found = estimate_planes(block.faces, block.constraints, "face \"A\"");
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_NEAR(found->reference.rotation.col(2).dot(base_from_block.col(2)), 1.0, 1e-12);
  EXPECT_EQ(found->values.size(), 3);
  EXPECT_NEAR(height_of(*found, 0), 0.0, 1e-9);
}

}  // namespace
}  // namespace artcal
