// What the residuals of simulated arms tell of their models: nothing of a rigid arm (as rarely as is stated), and of an
// arm that is none what was planted.
#include "identification/models/model_study.h"

#include <algorithm>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/simulation/simulate.h"
#include "core/units.h"
#include "identification/evaluation/residual_diagnostics.h"
#include "identification/identify.h"
#include "identification/least_squares/arm_fit.h"
#include "tests/support/plans.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
constexpr double encoder_noise = 2.0 * units::arcsecond;
constexpr double probing_noise = 1e-4;  // mm: there is none, and a covariance must not be singular

/// Six placements of a bar of three seats.
SimulationPlan plan() {
  SimulationPlan made = testing::plan_for(testing::bar_of(FeatureKind::Point), 25);
  made.nominal.probes[0].on_axis = true;
  made.nominal.probes[0].tip_in_last = {0.0, 0.0, 183.5};
  made.arm.arm = made.nominal;
  made.placements.clear();
  for (int p = 0; p < 6; ++p) {
    PlannedPlacement placement;
    placement.name = std::to_string(p);
    made.placements.push_back(placement);
  }
  made.probings[0].placements = {0, 1, 2, 3, 4, 5};
  return made;
}

struct Fitted {
  Recording recording;
  Constraints constraints;
  std::vector<Parameter> free;
  System system;
  ArmFit fit;
};

/// The arm fitted to the readings with noise of `seed` on top; starts at the true arm.
std::unique_ptr<Fitted> fitted(const Simulation& simulation, const SimulationPlan& made, std::uint64_t seed,
                               bool noise_is_stated = true) {
  auto result = std::make_unique<Fitted>();
  result->recording = simulation.recording;
  result->recording.arm = simulation.arm.arm;
  RandomStream random(seed, "noise");
  for (double& q : result->recording.joints.reshaped()) q += encoder_noise * random.normal();
  result->constraints = *build_constraints(result->recording, {made.artefacts[0].certified});
  for (const Parameter& parameter : parameters_of(result->recording.arm)) {
    const auto& name = parameter.name;
    if (name != "a6" && name != "d6" && name != "d1" && name != "theta1") result->free.push_back(parameter);
  }
  Noise noise;
  if (noise_is_stated) {
    noise.encoder = encoder_noise;
    noise.probing = probing_noise;
  }
  result->fit = *fit_arm(result->recording, result->constraints, result->recording.arm, result->free, noise, {});
  result->system = make_system(result->recording, result->constraints, result->fit.arm, result->free);
  return result;
}

TEST(ModelStudy, FindsNothingInRigidArmsAsOftenAsIsStated) {
  SimulationPlan made = plan();
  const auto simulation = simulate(made);
  ASSERT_TRUE(simulation);
  constexpr int recordings = 60;
  int alarms = 0;
  int tests = 0;
  int below = 0;  // 5 %
  for (int seed = 1; seed <= recordings; ++seed) {
    const auto fit = fitted(*simulation, made, static_cast<std::uint64_t>(seed));
    const ModelStudy study = search_residuals(fit->system, fit->fit, fit->recording);
    EXPECT_TRUE(study.done);
    alarms += study.findings.empty() ? 0 : 1;
    for (const ModelTest& test : study.tests) {
      ++tests;
      below += test.p < 0.05 ? 1 : 0;
    }
  }
  EXPECT_LE(alarms, 3);  // one in a hundred is stated; four or more in sixty: 0.3 % of the time
  EXPECT_GT(tests, 25 * recordings);
  EXPECT_NEAR(static_cast<double>(below) / tests, 0.05, 0.015);
}

// Encoder noise moves a tip by more the farther it is from the axis, and its coordinates together. Where it is not
// stated, the fit weights all coordinates alike, and an F test of its residuals finds effects in nine of these
// recordings.
TEST(ModelStudy, NoiseThatDiffersFromPostureToPostureIsNoEffect) {
  SimulationPlan made = plan();
  const auto simulation = simulate(made);
  ASSERT_TRUE(simulation);
  int alarms = 0;
  for (int seed = 1; seed <= 60; ++seed) {
    const auto fit = fitted(*simulation, made, static_cast<std::uint64_t>(seed), false);
    const ModelStudy study = search_residuals(fit->system, fit->fit, fit->recording);
    EXPECT_TRUE(study.done);
    alarms += study.findings.empty() ? 0 : 1;
  }
  EXPECT_LE(alarms, 3);  // of one in a hundred: 0.3 % of the time
}

TEST(ModelStudy, NamesAPeriodicRestWithAmplitudeAndPhase) {
  SimulationPlan made = plan();
  made.arm.joints[2].eccentricity[0] = {12.0 * units::arcsecond, 0.7};
  const auto simulation = simulate(made);
  const auto fit = fitted(*simulation, made, 1);
  const ModelStudy study = search_residuals(fit->system, fit->fit, fit->recording);
  ASSERT_FALSE(study.findings.empty());
  const ModelFinding& first = study.findings.front();
  EXPECT_EQ(first.effect, Effect::OncePerTurn);
  EXPECT_EQ(first.joint, 2);
  EXPECT_GT(first.u_amplitude, 0.0);
  EXPECT_NEAR(first.amplitude, 12.0 * units::arcsecond, 4.0 * first.u_amplitude);
  EXPECT_NEAR(first.phase, 0.7, 4.0 * first.u_amplitude / first.amplitude);
  EXPECT_LT(first.u_amplitude, 2.0 * units::arcsecond);
  EXPECT_EQ(study.findings.size(), 1U);  // and nothing else beside it
  EXPECT_LT(study.remaining_variance, 0.9);
  EXPECT_THAT(in_words(first), HasSubstr("joint 3: once per turn"));
}

TEST(ModelStudy, FindsTheSecondHarmonicOfAnotherJointToo) {
  SimulationPlan made = plan();
  made.arm.joints[1].eccentricity[1] = {9.0 * units::arcsecond, -1.0};
  made.arm.joints[4].eccentricity[0] = {20.0 * units::arcsecond, 2.0};
  const auto simulation = simulate(made);
  const auto fit = fitted(*simulation, made, 1);
  const ModelStudy study = search_residuals(fit->system, fit->fit, fit->recording);
  const auto found = [&](Effect effect, int joint) {
    return std::any_of(study.findings.begin(), study.findings.end(),
                       [&](const ModelFinding& f) { return f.effect == effect && f.joint == joint; });
  };
  EXPECT_TRUE(found(Effect::TwicePerTurn, 1));
  EXPECT_TRUE(found(Effect::OncePerTurn, 4));
  EXPECT_EQ(study.findings.size(), 2U);
}

/// Which way is down for the arm.
class Bending : public ::testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(Bending, IsFlagged) {
  SimulationPlan made = plan();
  made.nominal.gravity_in_base = made.arm.arm.gravity_in_base = 9.80665 * GetParam();
  for (std::size_t i = 0; i < 6; ++i) made.arm.joints[i].mass = 1.5 / static_cast<double>(i + 1);
  made.arm.joints[1].compliance = 3.0 * units::arcsecond / 1e3;  // an arc second a third of a newton metre
  const auto simulation = simulate(made);
  const auto fit = fitted(*simulation, made, 1);
  const ModelStudy study = search_residuals(fit->system, fit->fit, fit->recording);
  ASSERT_FALSE(study.findings.empty());
  EXPECT_EQ(study.findings.front().effect, Effect::Gravity);
  EXPECT_EQ(study.findings.front().joint, 1);
  EXPECT_THAT(in_words(study.findings.front()), HasSubstr("joint 2: bends under gravity"));
}

INSTANTIATE_TEST_SUITE_P(OnTheFloorOnAWallAndOnTheCeiling, Bending,
                         ::testing::Values(-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(),
                                           Eigen::Vector3d::UnitZ()));

TEST(ModelStudy, FindsAZeroThatDrifts) {
  SimulationPlan made = plan();
  auto simulation = simulate(made);
  const auto count = simulation->recording.joints.cols();
  for (Eigen::Index i = 0; i < count; ++i) {
    simulation->recording.joints(3, i) -= 10.0 * units::arcsecond * static_cast<double>(i) / static_cast<double>(count);
  }
  const auto fit = fitted(*simulation, made, 1);
  const ModelStudy study = search_residuals(fit->system, fit->fit, fit->recording);
  ASSERT_FALSE(study.findings.empty());
  EXPECT_EQ(study.findings.front().effect, Effect::Drift);
  EXPECT_EQ(study.findings.front().joint, 3);
  EXPECT_NEAR(2.0 * study.findings.front().amplitude, 10.0 * units::arcsecond, 2.0 * units::arcsecond);
}

TEST(ModelStudy, IsNotMadeOfReadingsWithoutNoise) {
  const SimulationPlan made = plan();
  const auto simulation = simulate(made);
  Recording recording = simulation->recording;
  recording.arm = simulation->arm.arm;
  const auto constraints = *build_constraints(recording, {made.artefacts[0].certified});
  IdentifyOptions options;
  options.leave_out = false;
  const auto result = identify(recording, constraints, options);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->model_study.done);
}

}  // namespace
}  // namespace artcal
