// Which groups a search takes, where the arm that was read is known.
#include "identification/models/automatic_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/joint_error_sessions.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using Verdict = ModelTrial::Verdict;

// Masses of no link and no temperature: gravity and thermal are not on offer, which keeps the search short.
Arm light_arm() {
  Arm arm = testing::nominal_arm();
  for (Joint& joint : arm.joints) joint.mass.reset();
  return arm;
}

test::Bound session_of(const Model& planted, std::uint64_t seed, Arm nominal = light_arm()) {
  const bool weighs = nominal.joints.front().mass.has_value();
  auto bound = testing::bar_session(nominal, testing::true_arm(nominal, planted, seed), seed, {}, 6);
  for (Reading& reading : bound.recording.readings) {
    reading.arm_temperature = weighs ? reading.arm_temperature : Reading::not_read;
  }
  return bound;
}

Identification searched(const test::Bound& bound) {
  IdentifyOptions options = testing::options_for({});
  options.leave_out = true;
  auto result = identify_automatically(bound.recording, bound.constraints, options);
  if (!result) throw std::runtime_error(result.error().text());
  return std::move(*result);
}

TEST(AutomaticModel, TakesWhatWasPlanted) {
  for (const ParameterGroup group : {ParameterGroup::Eccentricity, ParameterGroup::Gain, ParameterGroup::Coupling}) {
    const Identification result = searched(session_of({group}, 11));
    ASSERT_FALSE(result.model.empty()) << name_of(group);
    EXPECT_EQ(result.model.front(), group);
    EXPECT_LE(result.model.size(), 2u) << model_text(result.model);
    EXPECT_LT(result.chi_squared, 1.1 * result.chi_squared_high);
    EXPECT_EQ(result.trials.front().verdict, Verdict::Start);
    for (const ModelTrial& trial : result.trials) {
      if (trial.verdict == Verdict::Taken) {
        EXPECT_GT(trial.improvement, trial.limit * trial.improvement_noise);
      } else if (trial.verdict == Verdict::Refused) {
        EXPECT_FALSE(trial.refusal.empty());
      }
    }
  }
}

TEST(AutomaticModel, TakesBothOfTwo) {
  const Identification result =
      searched(session_of({ParameterGroup::Eccentricity, ParameterGroup::Gravity}, 5, testing::nominal_arm()));
  EXPECT_THAT(result.model, ::testing::IsSupersetOf({ParameterGroup::Eccentricity, ParameterGroup::Gravity}));
  EXPECT_LT(result.chi_squared, 1.1 * result.chi_squared_high);
}

// Six arms without errors: chance takes a group for one of them at most.
TEST(AutomaticModel, LeavesARigidArmAlone) {
  int taken = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Identification result = searched(session_of({}, seed));
    taken += static_cast<int>(result.model.size());
    EXPECT_EQ(result.trials.size(), 1u + 9u);
  }
  EXPECT_LE(taken, 1);
}

// Student's one-sided quantiles at 1 − 0.05/m (scipy.stats.t.ppf) for m = 1 … 6 groups; with two degrees of freedom, of
// three placements, and five, of six.
TEST(AutomaticModel, FewPlacementsNeedMoreThanTwiceTheirStandardError) {
  const double two[] = {2.91998558, 4.30265273, 5.33933279, 6.20534682, 6.96455672, 7.64880394};
  const double five[] = {2.01504837, 2.57058184, 2.91171049, 3.16338145, 3.36493000, 3.53411070};
  const Arm arm = light_arm();
  int taken = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    auto bound = testing::bar_session(arm, testing::true_arm(arm, {}, seed), seed, {}, seed == 3 ? 6 : 3);
    for (Reading& reading : bound.recording.readings) reading.arm_temperature = Reading::not_read;
    const Identification result = searched(bound);
    taken += static_cast<int>(result.model.size());
    EXPECT_EQ(result.left_out_chose_the_model, !result.model.empty());
    std::size_t judged = 0;
    for (const ModelTrial& trial : result.trials) {
      judged += trial.step == 1 && trial.verdict != Verdict::Refused ? 1 : 0;
    }
    ASSERT_GE(judged, 1u);
    ASSERT_LE(judged, 6u);
    for (const ModelTrial& trial : result.trials) {
      if (trial.step == 1 && trial.verdict != Verdict::Refused) {
        EXPECT_NEAR(trial.limit, (seed == 3 ? five : two)[judged - 1], 1e-6);
      }
    }
  }
  EXPECT_EQ(taken, 0);
}

TEST(AutomaticModel, NeedsPlacementsToJudgeBy) {
  const Arm arm = light_arm();
  const auto two = testing::bar_session(arm, arm, 1, {}, 2);
  IdentifyOptions options = testing::options_for({});
  options.leave_out = true;
  auto result = identify_automatically(two.recording, two.constraints, options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::Usage);
  EXPECT_THAT(result.error().message, HasSubstr("needs at least 3"));
  options.leave_out = false;
  result = identify_automatically(two.recording, two.constraints, options);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("left out"));
}

}  // namespace
}  // namespace artcal
