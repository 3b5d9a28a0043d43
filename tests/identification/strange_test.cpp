// Readings under another feature's name: no arm fits them, and what comes out is a refusal that names them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/programmes.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

enum Kind : std::size_t { ball_bar = 0, sphere_plate = 1, seats = 2 };

/// A session in which placement "0" was written down wrongly: the first `count` readings of feature "0" as "1",
/// and where `both_ways`, those of "1" as "0" too.
test::Bound mislabelled(std::size_t programme, int count, bool both_ways) {
  Arm nominal = test::gao_arm();
  nominal.probes.front().radius = 3.0;
  const Arm truth = testing::another_arm(nominal, {0.3, 0.1}, programme, 1);
  test::Bound bound = testing::session_of(testing::programmes[programme], nominal, truth, 7);
  Recording& recording = bound.recording;
  const int placement = recording.readings.front().placement;
  const int zero = recording.features.index_of("0");
  const int one = recording.features.index_of("1");
  int changed = 0;
  for (Reading& reading : recording.readings) {
    if (reading.placement != placement) continue;
    if (reading.feature == zero && changed < count) {
      reading.feature = one;
      ++changed;
    } else if (both_ways && reading.feature == one) {
      reading.feature = zero;
    }
  }
  return test::bind(recording, bound.constraints.artefacts);
}

std::string refusal(const test::Bound& bound, Loss loss = Loss::None) {
  IdentifyOptions options;
  options.leave_out = false;
  options.loss = loss;
  const auto result = identify(bound.recording, bound.constraints, options);
  return result ? "" : result.error().text();
}

TEST(Mislabelled, ReadingsOfSeatsAreNamed) {
  EXPECT_THAT(refusal(mislabelled(seats, 4, false)),
              AllOf(HasSubstr("feature \"1\" in placement \"0\""), HasSubstr("no arm fits")));
}

TEST(Mislabelled, ReadingsOfBallsAreNamed) {
  for (const std::size_t programme : {ball_bar, sphere_plate}) {
    EXPECT_THAT(refusal(mislabelled(programme, 3, false)), HasSubstr("in placement \"0\" are"));
  }
}

// Balls that have each other's names are round; their distances are not what is certified.
TEST(Mislabelled, BallsOfABarAreNamedByTheirDistance) {
  EXPECT_THAT(refusal(mislabelled(ball_bar, 1000, true)),
              AllOf(HasSubstr("in placement \"0\" is measured"), HasSubstr("each other's names")));
}

TEST(Mislabelled, AFewReadingsAreLetGoOfByALoss) { EXPECT_EQ(refusal(mislabelled(seats, 1, false), Loss::Cauchy), ""); }

}  // namespace
}  // namespace artcal
