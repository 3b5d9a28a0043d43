// Readings under another feature's name: no arm fits them, and what comes out is a refusal that names them.
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identification/evaluation/feature_plausibility.h"

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

// A session of many placements, four balls in each, of `readings` readings that scatter by sigma (mm) about spheres of
// which three unknowns are fitted; distances of centres that few readings determine up to thirty times worse. All of it
// normal numbers: nothing is wrong in it.
Evaluation sound_session(int placements, int readings, double sigma, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> decades(0.0, 1.5);
  Evaluation evaluation;
  for (int p = 0; p < placements; ++p) {
    for (int ball = 0; ball < 4; ++ball) {
      double squares = 0.0;
      for (int k = 0; k < readings - 3; ++k) {
        squares += std::pow(sigma * normal(random), 2);
      }
      const double rms = std::sqrt(squares / readings);
      evaluation.features.push_back({{"plate", std::to_string(p), std::to_string(ball)}, readings, rms, rms});
      const double gain = std::pow(10.0, decades(random));
      LengthDeviation length;
      length.first = evaluation.features.back().name;
      length.second = "other";
      length.certified.value = 500.0;
      length.at_temperature = 500.0;
      length.error = std::hypot(gain * sigma, 0.001) * normal(random);
      length.u = 0.001;
      length.gain = gain;
      evaluation.lengths.push_back(std::move(length));
    }
  }
  return evaluation;
}

// The worst of thousands is far from their median without anything being wrong with it.
TEST(StandingOut, OfASoundSessionOfAnySizeNothing) {
  for (const int placements : {3, 10, 100, 1000}) {
    for (const int readings : {4, 5, 25}) {
      for (std::uint64_t seed = 0; seed < 3; ++seed) {
        EXPECT_EQ(implausible_feature_text(sound_session(placements, readings, 0.1, seed), 0.3).value_or(""), "")
            << placements << " placements, " << readings << " readings";
      }
    }
  }
}

TEST(StandingOut, OfAnySizeWhatIsWrongIsNamed) {
  for (const int placements : {3, 10, 1000}) {
    Evaluation misread = sound_session(placements, 5, 0.01, 1);
    misread.features[7].rms = 0.5;
    EXPECT_THAT(implausible_feature_text(misread, 0.3).value_or(""),
                HasSubstr("feature \"3\" in placement \"1\" are 0.5 mm"))
        << placements;
    Evaluation swapped = sound_session(placements, 5, 0.01, 2);
    swapped.lengths[9].error = -3.0;
    EXPECT_THAT(implausible_feature_text(swapped, 0.3).value_or(""),
                HasSubstr("\"1\" and \"other\" in placement \"2\""))
        << placements;
  }
}

TEST(StandingOut, OfExactReadingsWhatIsWrongIsNamed) {
  Evaluation exact = sound_session(5, 5, 0.0, 1);
  EXPECT_FALSE(implausible_feature_text(exact, 0.3));
  exact.features[7].rms = 1.0;
  EXPECT_THAT(implausible_feature_text(exact, 0.3).value_or(""), HasSubstr("feature \"3\""));
}

}  // namespace
}  // namespace artcal
