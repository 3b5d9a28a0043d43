#include "fitting/segmentation/pattern/match.h"

#include <gmock/gmock.h>

#include "core/random.h"
#include "tests/support/scans.h"

namespace artcal::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Centres = std::vector<Eigen::Vector3d>;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Pattern pattern_of(const Centres& centres, double tolerance = 0.5) {
  const auto count = static_cast<Eigen::Index>(centres.size());
  Pattern pattern{std::vector<double>(centres.size(), 10.0), Eigen::MatrixXd(count, count), tolerance};
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      pattern.distances(i, j) = (centres[static_cast<std::size_t>(i)] - centres[static_cast<std::size_t>(j)]).norm();
    }
  }
  return pattern;
}

// The centres, some of them, at another pose and in another order, each off by up to 0.1 mm in each coordinate.
std::vector<FoundPoint> seen(const Centres& centres, const std::vector<int>& which) {
  RandomStream random(11, "pose");
  const Eigen::Matrix3d turn = random.rotation();
  std::vector<FoundPoint> found;
  for (const int i : which) {
    const Eigen::Vector3d off{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
    found.push_back({turn * centres[static_cast<std::size_t>(i)] + Eigen::Vector3d(1000.0, -50.0, 3.0) + off, 10.0});
  }
  return found;
}

const Centres bar = ball_bar({0.0, 300.0, 500.0, 1000.0});

TEST(Match, NamesWhatDistancesTell) {
  const Matching matching = match(pattern_of(bar), seen(bar, {2, 0, 3, 1})).value();
  ASSERT_THAT(matching.ways, SizeIs(1));
  EXPECT_THAT(matching.ways[0].found, ElementsAre(1, 3, 0, 2));
  EXPECT_EQ(matching.ways[0].count, 4);
  EXPECT_LT(matching.ways[0].worst, 0.4);
  EXPECT_LE(matching.ways[0].rms, matching.ways[0].worst);
}

TEST(Match, OneIsMissing) {
  const Matching matching = match(pattern_of(bar), seen(bar, {2, 0, 1})).value();
  ASSERT_THAT(matching.ways, SizeIs(1));
  EXPECT_THAT(matching.ways[0].found, ElementsAre(1, 2, 0, -1));
}

TEST(Match, StraysStandBeside) {
  auto found = seen(bar, {2, 0, 3, 1});
  found.insert(found.begin() + 1, {found[0].at + Eigen::Vector3d(0.0, 300.0, 0.0), 10.0});
  found.push_back({found[0].at + Eigen::Vector3d(50.0, 50.0, 0.0), 10.0});
  const Matching matching = match(pattern_of(bar), found).value();
  ASSERT_THAT(matching.ways, SizeIs(1));
  EXPECT_THAT(matching.ways[0].found, ElementsAre(2, 4, 0, 3));
}

TEST(Match, MissingAndStrayTogether) {
  auto found = seen(bar, {3, 1, 0});
  found.push_back({found[0].at + Eigen::Vector3d(77.0, 50.0, 9.0), 10.0});
  const Matching matching = match(pattern_of(bar), found).value();
  ASSERT_THAT(matching.ways, SizeIs(1));
  EXPECT_THAT(matching.ways[0].found, ElementsAre(2, 1, -1, 0));
}

// ---- symmetric artefacts: said, never chosen ---------------------------------------------------------------

TEST(Match, EqualDistancesHaveTwoWays) {
  const Centres symmetric = ball_bar({0.0, 250.0, 500.0});
  const auto found = seen(symmetric, {0, 1, 2});
  const Matching matching = match(pattern_of(symmetric), found).value();
  ASSERT_THAT(matching.ways, SizeIs(2));
  EXPECT_EQ(matching.ways[0].found[1], 1);
  EXPECT_EQ(matching.ways[0].found[0], matching.ways[1].found[2]);
}

TEST(Match, NearlyEqualIsEqualWithinTheTolerance) {
  const Centres nearly = ball_bar({0.0, 250.0, 500.6});
  EXPECT_THAT(match(pattern_of(nearly, 1.0), seen(nearly, {0, 1, 2}))->ways, SizeIs(2));
  EXPECT_THAT(match(pattern_of(nearly, 0.4), seen(nearly, {0, 1, 2}))->ways, SizeIs(1));
}

TEST(Match, TwoBallsHaveTwoWays) {
  const Centres two = ball_bar({0.0, 250.0});
  EXPECT_THAT(match(pattern_of(two), seen(two, {0, 1}))->ways, SizeIs(2));
}

TEST(Match, ASquarePlateHasEightWays) {
  const Centres plate = sphere_plate(5, 5, 100.0);
  std::vector<int> all;
  for (int i = 0; i < 25; ++i) all.push_back((7 * i) % 25);
  const Matching matching = match(pattern_of(plate), seen(plate, all)).value();
  EXPECT_THAT(matching.ways, SizeIs(8));
  // A corner still leaves the diagonal to mirror at; the corner beside it, too, tells all.
  const auto found = seen(plate, all);
  const auto place = [&](int ball) {
    return found[static_cast<std::size_t>(std::find(all.begin(), all.end(), ball) - all.begin())].at;
  };
  EXPECT_THAT(match(pattern_of(plate), found, {{0, place(0)}})->ways, SizeIs(2));
  const Matching told = match(pattern_of(plate), found, {{0, place(0)}, {4, place(4)}}).value();
  ASSERT_THAT(told.ways, SizeIs(1));
  for (int i = 0; i < 25; ++i)
    EXPECT_EQ(all[static_cast<std::size_t>(told.ways[0].found[static_cast<std::size_t>(i)])], i);
}

TEST(Match, APlateWithMissingBallsAndStrays) {
  const Centres plate = sphere_plate(5, 5, 100.0);
  std::vector<int> some;
  for (int i = 0; i < 25; ++i) {
    if (i != 3 && i != 12 && i != 21) some.push_back(i);
  }
  auto found = seen(plate, some);
  found.push_back({found[0].at + Eigen::Vector3d(33.0, -140.0, 60.0), 10.0});
  const Matching matching = match(pattern_of(plate), found, {{0, found[0].at}, {4, found[3].at}}).value();
  ASSERT_THAT(matching.ways, SizeIs(1));
  EXPECT_EQ(matching.ways[0].count, 22);
  EXPECT_EQ(matching.ways[0].found[3], -1);
  EXPECT_EQ(matching.ways[0].found[12], -1);
  EXPECT_EQ(matching.ways[0].found[21], -1);
  EXPECT_EQ(matching.ways[0].found[24], 21);
}

TEST(Match, RadiiTellWhatDistancesDoNot) {
  const Centres symmetric = ball_bar({0.0, 250.0, 500.0});
  Pattern pattern = pattern_of(symmetric);
  auto found = seen(symmetric, {0, 1, 2});
  pattern.radii[2] = found[2].radius = 15.0;
  const Matching matching = match(pattern, found).value();
  ASSERT_THAT(matching.ways, SizeIs(1));
  EXPECT_THAT(matching.ways[0].found, ElementsAre(0, 1, 2));
}

// ---- certificates that say little --------------------------------------------------------------------------------

TEST(Match, ACertificateOfNeighboursOnly) {
  Pattern pattern = pattern_of(bar);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (std::abs(i - j) > 1) pattern.distances(i, j) = unknown;
    }
  }
  const Matching matching = match(pattern, seen(bar, {2, 0, 3, 1})).value();
  ASSERT_THAT(matching.ways, SizeIs(1));
  EXPECT_THAT(matching.ways[0].found, ElementsAre(1, 3, 0, 2));
}

TEST(Match, NoDistancesAtAllSaySo) {
  Pattern pattern = pattern_of(bar);
  pattern.distances.setConstant(unknown);
  EXPECT_THAT(match(pattern, seen(bar, {2, 0, 3, 1}))->ways, SizeIs(24));
}

TEST(Match, TooManyWaysToCountIsAnError) {
  const Centres plate = sphere_plate(5, 5, 100.0);
  Pattern pattern = pattern_of(plate);
  pattern.distances.setConstant(unknown);
  std::vector<int> all;
  for (int i = 0; i < 25; ++i) all.push_back(i);
  const auto matching = match(pattern, seen(plate, all));
  ASSERT_FALSE(matching);
  EXPECT_EQ(matching.error().code, ErrorCode::NoSolution);
  EXPECT_THAT(matching.error().message, HasSubstr("state more distances"));
}

TEST(Match, ASingleSphere) {
  const Pattern pattern = pattern_of({Eigen::Vector3d::Zero()});
  EXPECT_THAT(match(pattern, {{{5.0, 5.0, 5.0}, 10.0}})->ways, SizeIs(1));
  EXPECT_THAT(match(pattern, {{{5.0, 5.0, 5.0}, 10.0}, {{50.0, 5.0, 5.0}, 10.0}})->ways, SizeIs(2));
}

// ---- nothing fits ------------------------------------------------------------------------------------------------

TEST(Match, AnotherArtefactFitsNowhere) {
  const Centres other = ball_bar({0.0, 310.0, 530.0, 1100.0});
  EXPECT_THAT(match(pattern_of(bar), seen(other, {0, 1, 2, 3}))->ways, IsEmpty());
  EXPECT_THAT(match(pattern_of(bar), {})->ways, IsEmpty());
  EXPECT_THAT(match(pattern_of(bar), seen(bar, {1}))->ways, IsEmpty());
}

TEST(Match, WrongCalls) {
  const auto found = seen(bar, {0, 1});
  Pattern pattern = pattern_of(bar);
  pattern.tolerance = 0.0;
  EXPECT_EQ(match(pattern, found).error().code, ErrorCode::Usage);
  pattern = pattern_of(bar);
  pattern.radii.pop_back();
  EXPECT_EQ(match(pattern, found).error().code, ErrorCode::Usage);
  EXPECT_EQ(match(pattern_of(bar), found, {{4, Eigen::Vector3d::Zero()}}).error().code, ErrorCode::Usage);
}

}  // namespace
}  // namespace artcal::testing
