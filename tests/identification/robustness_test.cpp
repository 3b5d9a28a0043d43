// Other arms, placements and noise, begun from errors between those of a good nominal arm and several mm and
// degrees: whether the truth is found, judged by lengths in the volume. More of them, by a simulator of its own:
// bench/basin_study.
#include <gtest/gtest.h>

#include "tests/support/programmes.h"

namespace artcal {
namespace {

using testing::Difficulty;

class OtherArms : public ::testing::TestWithParam<std::tuple<std::size_t, Difficulty>> {};

TEST_P(OtherArms, AreFound) {
  const auto& [programme, difficulty] = GetParam();
  Arm nominal = test::gao_arm();
  nominal.probes.front().radius = 3.0;
  IdentifyOptions options;
  options.leave_out = false;
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    const Arm truth = testing::another_arm(nominal, difficulty, programme, seed);
    const test::Bound bound =
        testing::session_of(testing::programmes[programme], nominal, truth, 100 * programme + seed);
    const auto result = identify(bound.recording, bound.constraints, options);
    ASSERT_TRUE(result) << "seed " << seed << ": " << result.error().text();
    EXPECT_LT(testing::length_rms(truth, result->arm), 0.05) << "seed " << seed;
  }
}

const auto every_programme = ::testing::Range(std::size_t{0}, testing::programmes.size());
INSTANTIATE_TEST_SUITE_P(AGoodNominalArm, OtherArms,
                         ::testing::Combine(every_programme, ::testing::Values(Difficulty{0.3, 0.1})));
INSTANTIATE_TEST_SUITE_P(ARoughOne, OtherArms,
                         ::testing::Combine(every_programme, ::testing::Values(Difficulty{3.0, 1.5})));

}  // namespace
}  // namespace artcal
