#include "fitting/segmentation/segment.h"

#include <gmock/gmock.h>

#include "core/parallel.h"
#include "tests/support/scans.h"

namespace artcal::testing {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

ScanSettings a_bar() {
  ScanSettings s;
  s.centres = ball_bar({0.0, 160.0, 260.0});
  s.spacing = 2.0;
  s.ball_spacing = 0.8;
  return s;
}

ScanContents contents_of(const ScanSettings& settings) {
  const auto count = static_cast<Eigen::Index>(settings.centres.size());
  ScanContents contents;
  contents.radii.assign(settings.centres.size(), settings.radius);
  contents.distances.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      contents.distances(i, j) =
          (settings.centres[static_cast<std::size_t>(i)] - settings.centres[static_cast<std::size_t>(j)]).norm();
    }
  }
  return contents;
}

void expect_at(const std::optional<FoundSphere>& sphere, const Eigen::Vector3d& truth) {
  ASSERT_TRUE(sphere.has_value());
  EXPECT_LT((sphere->fitted.feature.centre - truth).norm(), 0.02);
}

TEST(Segment, NamesTheBallsOfABar) {
  const ScanSettings settings = a_bar();
  const SimulatedScan scan = simulate_scan(settings);
  const Segmentation result = segment(scan.points, contents_of(settings)).value();
  EXPECT_EQ(result.status, SegmentStatus::Complete);
  ASSERT_THAT(result.spheres, SizeIs(3));
  for (std::size_t i = 0; i < 3; ++i) expect_at(result.spheres[i], scan.centres[i]);
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(Segment, OneThreadGivesTheDigitsOfSeveral) {
  ScanSettings settings = a_bar();
  settings.spacing = 0.7;
  settings.ball_spacing = 0.15;
  const SimulatedScan scan = simulate_scan(settings);
  ASSERT_GT(scan.points.cols(), 150'000);
  ScanContents contents = contents_of(settings);
  contents.planes = 1;
  const Segmentation several = segment(scan.points, contents).value();
  const OneThreadOnly only;
  const Segmentation one = segment(scan.points, contents).value();
  ASSERT_EQ(several.status, SegmentStatus::Complete);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(several.spheres[i]->points, one.spheres[i]->points);
    EXPECT_EQ(several.spheres[i]->fitted.feature.parameters(), one.spheres[i]->fitted.feature.parameters());
    EXPECT_EQ(several.spheres[i]->coverage, one.spheres[i]->coverage);
    EXPECT_EQ(several.spheres[i]->u_seen_radius, one.spheres[i]->u_seen_radius);
  }
  EXPECT_EQ(several.planes.front().points, one.planes.front().points);
  EXPECT_EQ(several.planes.front().fitted.feature.parameters(), one.planes.front().fitted.feature.parameters());
  ASSERT_EQ(several.rejected.size(), one.rejected.size());
  for (std::size_t i = 0; i < one.rejected.size(); ++i) EXPECT_EQ(several.rejected[i].why, one.rejected[i].why);
}

TEST(Segment, ABallIsMissingAndAnotherStandsBeside) {
  ScanSettings settings = a_bar();
  settings.balls_not_there = {2};
  settings.strays = {{80.0, 60.0, 4.0}};
  const SimulatedScan scan = simulate_scan(settings);
  // Two balls can be swapped; where one of them is breaks the tie.
  const ScanContents contents = contents_of(settings);
  EXPECT_EQ(segment(scan.points, contents)->status, SegmentStatus::Ambiguous);
  SegmentOptions options;
  options.hints = {{0, scan.centres[0]}};
  const Segmentation result = segment(scan.points, contents, options).value();
  EXPECT_EQ(result.status, SegmentStatus::Partial);
  expect_at(result.spheres[0], scan.centres[0]);
  expect_at(result.spheres[1], scan.centres[1]);
  EXPECT_FALSE(result.spheres[2].has_value());
  EXPECT_THAT(result.rejected, Contains(Field(&RejectedSphere::reason, RejectionReason::Stray)));
}

TEST(Segment, ASymmetricBarIsNotNamed) {
  ScanSettings settings = a_bar();
  settings.centres = ball_bar({0.0, 130.0, 260.0});
  const SimulatedScan scan = simulate_scan(settings);
  const Segmentation result = segment(scan.points, contents_of(settings)).value();
  EXPECT_EQ(result.status, SegmentStatus::Ambiguous);
  EXPECT_THAT(result.matching.ways, SizeIs(2));
  EXPECT_THAT(result.spheres, SizeIs(3));
}

TEST(Segment, AnotherBarDoesNotMatch) {
  const SimulatedScan scan = simulate_scan(a_bar());
  ScanSettings other = a_bar();
  other.centres = ball_bar({0.0, 200.0, 333.0});
  const Segmentation result = segment(scan.points, contents_of(other)).value();
  EXPECT_EQ(result.status, SegmentStatus::NoMatch);
  EXPECT_THAT(result.matching.ways, IsEmpty());
  EXPECT_THAT(result.spheres, SizeIs(3));
}

TEST(Segment, NothingIsThere) {
  ScanSettings settings = a_bar();
  settings.balls_not_there = {0, 1, 2};
  settings.strays = {{0.0, 0.0, 0.0}};
  settings.radius = 30.0;
  const SimulatedScan scan = simulate_scan(settings);
  const Segmentation result = segment(scan.points, contents_of(a_bar())).value();
  EXPECT_EQ(result.status, SegmentStatus::Nothing);
  EXPECT_EQ(segment(Eigen::Matrix3Xd(3, 0), contents_of(a_bar()))->status, SegmentStatus::Nothing);
}

TEST(Segment, AnotherUnitIsSaid) {
  const ScanSettings settings = a_bar();
  const SimulatedScan scan = simulate_scan(settings);
  const ScanContents contents = contents_of(settings);
  const auto warnings = [&](double factor) {
    const Eigen::Matrix3Xd points = scan.points * factor;
    const Segmentation result = segment(points, contents).value();
    EXPECT_EQ(result.status, SegmentStatus::Nothing);
    return result.warnings;
  };
  EXPECT_THAT(warnings(1e-3), Contains(HasSubstr("metres read as millimetres")));
  EXPECT_THAT(warnings(1e3), Contains(HasSubstr("millimetres read as metres")));
  EXPECT_THAT(warnings(1.0 / 25.4), Contains(HasSubstr("inches read as millimetres")));
  EXPECT_THAT(warnings(7.0), IsEmpty());
}

TEST(Segment, TheTableIsAPlaneAndTheBallsAreNot) {
  ScanSettings settings = a_bar();
  settings.turned = false;
  settings.offset = {0.0, 0.0, 1000.0};
  const SimulatedScan scan = simulate_scan(settings);
  ScanContents contents = contents_of(settings);
  contents.planes = 1;
  const Segmentation result = segment(scan.points, contents).value();
  EXPECT_EQ(result.status, SegmentStatus::Complete);
  ASSERT_THAT(result.planes, SizeIs(1));
  const Plane& plane = result.planes[0].fitted.feature;
  EXPECT_GT(std::abs(plane.normal.z()), 1.0 - 1e-9);
  EXPECT_NEAR(plane.point.z(), 1000.0 - 4.0 * settings.radius, 0.002);
  long wrong = 0;
  for (const int i : result.planes[0].points) wrong += scan.labels[static_cast<std::size_t>(i)] == on::table ? 0 : 1;
  EXPECT_LT(wrong, 0.001 * static_cast<double>(result.planes[0].points.size()));
  EXPECT_GT(result.planes[0].points.size(), 0.85 * static_cast<double>(scan.points_on(on::table).size()));
}

TEST(Segment, PlanesAlone) {
  RandomStream random(1, "gauge block");
  Eigen::Matrix3Xd points(3, 9000);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double z = i < 5000 ? 0.0 : 40.0;
    points.col(i) << random.uniform(0.0, 100.0), random.uniform(0.0, 60.0), z + 0.01 * random.normal();
  }
  ScanContents contents;
  contents.planes = 2;
  const Segmentation result = segment(points, contents).value();
  EXPECT_EQ(result.status, SegmentStatus::Complete);
  ASSERT_THAT(result.planes, SizeIs(2));
  EXPECT_NEAR(result.planes[0].fitted.feature.point.z(), 0.0, 0.001);
  EXPECT_NEAR(result.planes[1].fitted.feature.point.z(), 40.0, 0.001);
  EXPECT_GT(result.planes[0].points.size(), 4900u);
  EXPECT_GT(result.planes[1].points.size(), 3900u);
  contents.planes = 3;
  EXPECT_EQ(segment(points, contents)->status, SegmentStatus::Partial);
}

TEST(Segment, WrongCalls) {
  EXPECT_EQ(segment(Eigen::Matrix3Xd::Zero(3, 5), {}).error().code, ErrorCode::Usage);
  SegmentOptions options;
  options.tolerance = -1.0;
  EXPECT_EQ(segment(Eigen::Matrix3Xd::Zero(3, 5), contents_of(a_bar()), options).error().code, ErrorCode::Usage);
}

}  // namespace
}  // namespace artcal::testing
