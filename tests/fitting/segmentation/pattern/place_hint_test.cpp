#include "fitting/segmentation/pattern/place_hint.h"

#include <gmock/gmock.h>

#include "fitting/segmentation/pattern/match.h"
#include "tests/support/scans.h"

namespace artcal::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Fault = UnmetHint::Fault;
using Centres = std::vector<Eigen::Vector3d>;

Pattern pattern_of(const Centres& centres, double radius, double tolerance) {
  const auto count = static_cast<Eigen::Index>(centres.size());
  Pattern pattern{std::vector<double>(centres.size(), radius), Eigen::MatrixXd(count, count), tolerance};
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      pattern.distances(i, j) = (centres[static_cast<std::size_t>(i)] - centres[static_cast<std::size_t>(j)]).norm();
    }
  }
  return pattern;
}

std::vector<FoundPoint> found_of(const Centres& centres, const std::vector<int>& which, double radius) {
  std::vector<FoundPoint> found;
  for (const int i : which) {
    found.push_back({centres[static_cast<std::size_t>(i)], radius});
  }
  return found;
}

// A plate of 5 x 5 balls without its first column: whoever states the place of a ball of that column must not be given
// the neighbour instead, for with it all 20 others get their neighbour's name.
TEST(PlaceHint, AMissingBallIsNotItsNeighbour) {
  const Centres plate = sphere_plate(5, 5, 83.0);
  const Pattern pattern = pattern_of(plate, 11.0, 1.1);
  std::vector<int> there;
  for (int i = 0; i < 25; ++i) {
    if (i % 5 != 0) {
      there.push_back(i);
    }
  }
  const auto found = found_of(plate, there, 11.0);
  const Matching matching = match(pattern, found, {{0, plate[0]}, {20, plate[20]}}).value();
  EXPECT_THAT(matching.ways, IsEmpty());
  ASSERT_THAT(matching.unmet, SizeIs(2));
  EXPECT_EQ(matching.unmet[1].hint, 1);
  EXPECT_EQ(matching.unmet[0].fault, Fault::NothingNear);
  EXPECT_NEAR(matching.unmet[0].distance, 83.0, 1e-12);
  EXPECT_NEAR(matching.unmet[0].limit, 12.1, 1e-12);
  EXPECT_THAT(fault_text(matching.unmet[0]), HasSubstr("the nearest is 83 mm away"));
  // Balls that are there tell which is which.
  const Matching told = match(pattern, found, {{1, plate[1]}, {21, plate[21]}, {4, plate[4]}}).value();
  EXPECT_THAT(told.unmet, IsEmpty());
  ASSERT_THAT(told.ways, SizeIs(1));
  for (std::size_t i = 0; i < there.size(); ++i) {
    EXPECT_EQ(told.ways[0].found[static_cast<std::size_t>(there[i])], static_cast<int>(i));
  }
}

TEST(PlaceHint, ARoughPlaceIsEnough) {
  const Centres bar = ball_bar({0.0, 300.0});
  const Pattern pattern = pattern_of(bar, 12.7, 1.27);
  const auto found = found_of(bar, {1, 0}, 12.7);
  EXPECT_THAT(match(pattern, found, {{0, Eigen::Vector3d(0.0, 9.0, 9.0)}})->ways, SizeIs(1));
  EXPECT_THAT(match(pattern, found, {{0, Eigen::Vector3d(0.0, 10.0, 10.0)}})->unmet, SizeIs(1));
}

// Whatever the tolerance, a place is nearer to its own ball than to a neighbour.
TEST(PlaceHint, AWideToleranceDoesNotReachTheNeighbour) {
  const Centres plate = sphere_plate(2, 3, 30.0);
  const Pattern pattern = pattern_of(plate, 10.0, 25.0);
  EXPECT_EQ(place_limit(pattern, 0), 15.0);
  const auto found = found_of(plate, {1, 2, 3, 4, 5}, 10.0);
  EXPECT_THAT(match(pattern, found, {{0, plate[0]}})->unmet, SizeIs(1));
}

TEST(PlaceHint, ContradictionsAreNamed) {
  const Centres bar = ball_bar({0.0, 300.0, 700.0});
  Pattern pattern = pattern_of(bar, 10.0, 1.0);
  auto found = found_of(bar, {0, 1, 2}, 10.0);
  const auto same = match(pattern, found, {{0, bar[0]}, {1, bar[0]}}).value();
  ASSERT_THAT(same.unmet, SizeIs(1));
  EXPECT_EQ(same.unmet[0].fault, Fault::SameAsOther);
  const auto twice = match(pattern, found, {{0, bar[0]}, {0, bar[1]}}).value();
  ASSERT_THAT(twice.unmet, SizeIs(1));
  EXPECT_EQ(twice.unmet[0].fault, Fault::SameAsOther);
  EXPECT_THAT(match(pattern, found, {{0, bar[0]}, {0, bar[0]}})->unmet, IsEmpty());
  pattern.radii[2] = found[2].radius = 15.0;
  const auto other = match(pattern, found, {{0, bar[2]}}).value();
  ASSERT_THAT(other.unmet, SizeIs(1));
  EXPECT_EQ(other.unmet[0].fault, Fault::OtherRadius);
}

}  // namespace
}  // namespace artcal::testing
