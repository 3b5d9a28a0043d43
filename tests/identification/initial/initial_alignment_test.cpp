#include "identification/initial/initial_alignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identification/identify.h"
#include "tests/support/probing/outcome.h"

namespace artcal {
namespace {

using probing::Kind;
using probing::Outcome;
using probing::Probing;

struct Counts {
  int found = 0, refused = 0, wrong = 0;
};

Expected<Identification> identified(const probing::Bound& bound, double stated_noise) {
  IdentifyOptions options;
  options.leave_out = false;
  if (stated_noise > 0.0) options.noise.reading = stated_noise;
  return identify(bound.recording, bound.constraints, options);
}

Counts count(Probing asked, int sessions) {
  Counts counts;
  for (int i = 0; i < sessions; ++i) {
    asked.seed = static_cast<std::uint64_t>(1000 * i) + static_cast<std::uint64_t>(asked.kind);
    const probing::Session session = probing::probe(asked);
    const double stated = i % 2 == 0 ? asked.noise : 0.0;
    const Outcome outcome = probing::outcome(session, identified(probing::bound(session, stated), stated));
    counts.found += outcome == Outcome::Found ? 1 : 0;
    counts.refused += outcome == Outcome::Refused ? 1 : 0;
    counts.wrong += outcome == Outcome::Wrong ? 1 : 0;
  }
  return counts;
}

// As people probe: the stylus points at the ball within 30 degrees. With the alignment that took balls for points and
// let the tip go, half of these bars and nearly all of the plates were not found, or found wrongly (l 20 mm too long).
TEST(InitialAlignment, FindsArmsThatProbeAsPeopleDo) {
  for (const Kind kind : {Kind::Bar4, Kind::Bar2, Kind::Plate, Kind::StepGauge, Kind::Planes, Kind::Mixed}) {
    for (const double rough : {2.0, 10.0}) {
      const Counts counts = count({.kind = kind, .placements = 6, .rough = rough}, 4);
      EXPECT_EQ(counts.found, 4) << probing::name_of(kind) << ", s = " << rough << ", wrong: " << counts.wrong;
    }
  }
}

TEST(InitialAlignment, FindsArmsWhateverTheStylusPointsTo) {
  for (const double within : {10.0, 60.0, 180.0}) {
    const Counts counts = count({.kind = Kind::Bar4, .placements = 6, .stylus_within = within, .rough = 5.0}, 4);
    EXPECT_EQ(counts.found, 4) << within << " degrees";
  }
}

// 10 mm and 3 degrees off: found, or refused.
TEST(InitialAlignment, NeverReturnsAWrongArmFromFarOff) {
  for (const Kind kind : {Kind::Bar3, Kind::Bar4, Kind::Plate, Kind::Ball, Kind::Planes}) {
    EXPECT_EQ(count({.kind = kind, .placements = 4, .stylus_within = 10.0, .rough = 30.0}, 4).wrong, 0)
        << probing::name_of(kind);
  }
}

TEST(InitialAlignment, OneReadingUnderAnotherNameIsRefused) {
  for (const Kind kind : {Kind::Bar4, Kind::Plate, Kind::Seats}) {
    const Counts counts = count({.kind = kind, .placements = 5, .rough = 2.0, .wrong_labels = 1}, 2);
    EXPECT_EQ(counts.refused, 2) << probing::name_of(kind);
  }
}

// A reading 100 mm and more off moves the least-squares centre of its ball, from which a robust loss never came back.
TEST(InitialAlignment, ALossLetsGoOfTheReadingUnderAnotherName) {
  for (const Kind kind : {Kind::Bar2, Kind::Bar4, Kind::Plate, Kind::Seats, Kind::StepGauge}) {
    for (const double stated : {0.0, 0.015}) {
      const probing::Session session =
          probing::probe({.kind = kind, .placements = 5, .rough = 3.0, .wrong_labels = 1, .seed = 31});
      const probing::Bound bound = probing::bound(session, stated);
      IdentifyOptions options;
      options.leave_out = false;
      options.loss = Loss::Cauchy;
      if (stated > 0.0) options.noise.reading = stated;
      const auto result = identify(bound.recording, bound.constraints, options);
      EXPECT_EQ(probing::outcome(session, result), Outcome::Found)
          << probing::name_of(kind) << (result ? "" : ": " + result.error().text());
    }
  }
}

TEST(InitialAlignment, TheRefusalNamesTheReading) {
  const probing::Session session =
      probing::probe({.kind = Kind::Bar4, .placements = 5, .rough = 2.0, .wrong_labels = 1, .seed = 8});
  std::size_t wrong = 0;
  const probing::Session sound = probing::probe({.kind = Kind::Bar4, .placements = 5, .rough = 2.0, .seed = 8});
  while (session.touches[wrong].feature == sound.touches[wrong].feature) ++wrong;
  const auto result = identified(probing::bound(session, 0.015), 0.015);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().text(),
              ::testing::HasSubstr("all but 1 reading: readings.csv:" + std::to_string(wrong + 2)));
}

TEST(InitialAlignment, TellsWhichAlignmentLedToTheArm) {
  const probing::Session session = probing::probe({.kind = Kind::Bar4, .placements = 6, .rough = 5.0});
  const auto rough = identified(probing::bound(session, 0.015), 0.015);
  ASSERT_TRUE(rough) << rough.error().text();
  EXPECT_EQ(rough->alignment, Alignment::StylusCentres);
  EXPECT_EQ(rough->attempts, 1);
  probing::Session good = session;
  good.nominal = good.truth;
  const auto found = identified(probing::bound(good, 0.015), 0.015);
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_EQ(found->alignment, Alignment::None);
}

// Both ends of one arm: whatever nominal arm the search begins at, the arm found is the same.
TEST(InitialAlignment, LeadsToTheSameArmFromAnyStart) {
  probing::Session session = probing::probe({.kind = Kind::Bar4, .placements = 7, .rough = 3.0});
  const auto far = identified(probing::bound(session, 0.015), 0.015);
  session.nominal = session.truth;
  const auto near = identified(probing::bound(session, 0.015), 0.015);
  ASSERT_TRUE(far && near);
  EXPECT_NEAR(far->chi_squared, near->chi_squared, 1e-6 * near->chi_squared);
  EXPECT_LT(probing::length_error(probing::chain_of(near->arm), probing::chain_of(far->arm)), 1e-6);
}

}  // namespace
}  // namespace artcal
