#include "identification/weak_parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/probing/outcome.h"

namespace artcal {
namespace {

using probing::Kind;

IdentifyOptions stated(double noise) {
  IdentifyOptions options;
  options.leave_out = false;
  options.noise.reading = noise;
  return options;
}

// A single ball that the stylus always points at is hardly more than a point: it hardly determines the scale. The fit
// of all parameters runs off to an arm without lengths, whose tip is everywhere at the ball's radius from one point.
TEST(WeakParameters, AreHeldByAPriorThatIsSaidAndCounted) {
  int with_prior = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto session = probing::probe(
        {.kind = Kind::Ball, .placements = 6, .stylus_within = 10.0, .noise = 0.05, .rough = 1.0, .seed = seed});
    const auto bound = probing::bound(session, 0.05);
    const auto result = identify(bound.recording, bound.constraints, stated(0.05));
    EXPECT_NE(probing::outcome(session, result), probing::Outcome::Wrong)
        << seed << ": " << (result ? probing::length_error(session.truth, probing::chain_of(result->arm)) : 0.0);
    if (result && !result->weak.empty()) {
      ++with_prior;
      EXPECT_THAT(result->warnings, ::testing::Contains(::testing::HasSubstr("weak prior")));
      for (const IdentifiedParameter& parameter : result->parameters) {
        if (parameter.state == ParameterState::Weak) {
          EXPECT_GT(parameter.u, 0.0) << parameter.parameter.name;
        }
      }
    }
  }
  RecordProperty("with_prior", with_prior);
}

TEST(WeakParameters, AreNoneWhereReadingsAreVaried) {
  const auto session = probing::probe({.kind = Kind::Bar4, .placements = 7});
  const auto bound = probing::bound(session, 0.015);
  const auto result = identify(bound.recording, bound.constraints, stated(0.015));
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_THAT(result->weak, ::testing::IsEmpty());
}

}  // namespace
}  // namespace artcal
