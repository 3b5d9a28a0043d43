// Where to put an artefact next: plans against chance, and against what their recordings then give.
#include "identification/planning/planning.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/simulation/possible_session.h"
#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

namespace artcal {
namespace {

constexpr double arcsecond = std::numbers::pi / 180.0 / 3600.0;

Artefact ball_bar() {
  Artefact bar;
  bar.name = "bar";
  for (const char* name : {"A", "B"}) {
    bar.features.push_back(testing::feature_of(name, FeatureKind::Sphere));
    bar.features.back().radius = 12.7;
  }
  bar.distances = {{0, 1, 500.0, 3e-4}};
  return bar;
}

struct Possible {
  Simulation simulation;
  Constraints constraints;
};

Possible possible(std::uint64_t seed, int placements, int readings) {
  Arm arm = test::gao_arm();
  arm.probes.front().radius = 3.0;
  const auto simulation = simulate(possible_session(arm, ball_bar(), {placements, readings, seed}));
  if (!simulation) throw std::runtime_error(simulation.error().text());
  auto constraints = build_constraints(simulation->recording, {ball_bar()});
  if (!constraints) throw std::runtime_error(constraints.error().text());
  return {*simulation, std::move(*constraints)};
}

PlanningOptions options_of(int placements, int readings, std::uint64_t seed) {
  PlanningOptions options;
  options.placements = placements;
  options.readings = readings;
  options.noise.encoder = 2.0 * arcsecond;
  options.noise.probing = 0.003;
  options.seed = seed;
  return options;
}

Planning planned(const Possible& pool, const PlanningOptions& options) {
  auto plan = plan_session(pool.simulation, pool.constraints, nullptr, nullptr, options);
  if (!plan) throw std::runtime_error(plan.error().text());
  return std::move(*plan);
}

// Five planned placements against ten by chance (medians of twenty), both by lengths that nothing was chosen by. What
// the readings of the length itself add is the same for both, and most of the worst.
TEST(PlanSession, HalfOfAPlanIsWorthAllOfChance) {
  double mean = 0.0;
  double mean_by_chance = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    PlanningOptions options = options_of(5, 8, seed);
    options.random_placements = 10;
    const Planning half = planned(possible(seed, 60, 16), options);
    EXPECT_LT(half.planned.u_of_arm.mean, 1.05 * half.random_of_arm.mean) << "seed " << seed;
    EXPECT_LT(half.planned.u_of_arm.worst, 1.06 * half.random_of_arm.worst) << "seed " << seed;
    EXPECT_LT(half.planned.u.worst, 1.08 * half.random.worst) << "seed " << seed;
    mean += half.planned.u.mean / 20.0;
    mean_by_chance += half.random.mean / 20.0;
  }
  EXPECT_LT(mean, mean_by_chance);
}

TEST(PlanSession, GoalsAreLoweredAndTheSameEveryTime) {
  const Possible pool = possible(3, 40, 12);
  PlanningOptions options = options_of(4, 8, 3);
  const Planning by_worst = planned(pool, options);
  const Planning again = planned(pool, options);
  ASSERT_EQ(by_worst.chosen.size(), again.chosen.size());
  for (std::size_t i = 0; i < by_worst.chosen.size(); ++i) {
    EXPECT_EQ(by_worst.chosen[i].candidate, again.chosen[i].candidate);
    EXPECT_EQ(by_worst.chosen[i].readings, again.chosen[i].readings);
  }
  options.goal = Goal::Mean;
  const Planning by_mean = planned(pool, options);
  EXPECT_LT(by_mean.planned.u.mean, 1.001 * by_worst.planned.u.mean);
  EXPECT_LT(by_worst.planned.u.worst, by_worst.random.worst);
  for (const ChosenPlacement& chosen : by_mean.chosen) {
    EXPECT_EQ(chosen.readings.size(), 16u);
  }
}

// The recording of a plan, read with encoders that scatter as stated, gives an arm as good as was foretold.
TEST(PlanSession, ForetellsWhatItsRecordingGives) {
  double squares = 0.0;
  constexpr int sessions = 12;
  const Possible pool = possible(9, 30, 12);
  PlanningOptions options = options_of(5, 8, 9);
  options.noise.probing = 1e-4;  // moves the tip, which here does not move
  const Planning plan = planned(pool, options);
  for (std::uint64_t session = 0; session < sessions; ++session) {
    RandomStream random(session, "noise");
    Recording recording = pool.simulation.recording;
    std::vector<int> taken;
    for (const auto& chosen : plan.chosen) taken.insert(taken.end(), chosen.readings.begin(), chosen.readings.end());
    recording.readings.clear();
    recording.joints.resize(recording.joints.rows(), static_cast<Eigen::Index>(taken.size()));
    for (std::size_t i = 0; i < taken.size(); ++i) {
      recording.readings.push_back(pool.simulation.recording.readings[static_cast<std::size_t>(taken[i])]);
      for (Eigen::Index joint = 0; joint < recording.joints.rows(); ++joint) {
        recording.joints(joint, static_cast<Eigen::Index>(i)) =
            pool.simulation.recording.joints(joint, taken[i]) + 2.0 * arcsecond * random.normal();
      }
    }
    recording.noise = options.noise;
    IdentifyOptions identify_options;
    identify_options.leave_out = false;
    identify_options.noise = options.noise;
    const auto result = test::identified(test::bind(recording, {ball_bar()}), identify_options);
    squares += std::pow(testing::length_rms(pool.simulation.arm.arm, result.arm), 2) / sessions;
  }
  // Twelve sessions of some 24 parameters: the ratio scatters by about 6 %.
  EXPECT_NEAR(std::sqrt(squares) / plan.planned.u_of_arm.mean, 1.0, 0.2);
}

TEST(PlanSession, WhatIsMeasuredCounts) {
  const Possible pool = possible(5, 20, 12);
  const Possible before = possible(6, 6, 10);
  const PlanningOptions options = options_of(2, 8, 5);
  const auto plan =
      plan_session(pool.simulation, pool.constraints, &before.simulation.recording, &before.constraints, options);
  ASSERT_TRUE(plan) << plan.error().text();
  ASSERT_TRUE(plan->measured);
  const Planning alone = planned(pool, options);
  EXPECT_LT(plan->planned.u.mean, plan->measured->u.mean);
  EXPECT_LT(plan->planned.u.mean, alone.planned.u.mean);
  EXPECT_GT(plan->planned.u.mean, plan->all.u.mean);
}

TEST(PlanSession, RefusesWhatCannotBePlanned) {
  const Possible pool = possible(5, 3, 6);
  const auto refusal = [&](const PlanningOptions& options) {
    const auto plan = plan_session(pool.simulation, pool.constraints, nullptr, nullptr, options);
    return plan ? std::string("accepted") : plan.error().text();
  };
  EXPECT_THAT(refusal(options_of(4, 4, 1)), ::testing::HasSubstr("4 placements are to be chosen, but only 3"));
  PlanningOptions silent = options_of(2, 4, 1);
  silent.noise = {};
  EXPECT_THAT(refusal(silent), ::testing::HasSubstr("noise of the readings is not stated"));
}

TEST(Observability, OfKnownValues) {
  const Observability o = observability_of(Eigen::Vector3d(4.0, 2.0, 1.0), 16);
  EXPECT_DOUBLE_EQ(o.o1, 0.5);  // cube root of 8 over four
  EXPECT_DOUBLE_EQ(o.o2, 0.25);
  EXPECT_DOUBLE_EQ(o.o3, 1.0);
  EXPECT_DOUBLE_EQ(o.o4, 0.25);
  EXPECT_DOUBLE_EQ(o.o5, 1.0 / 1.75);
}

}  // namespace
}  // namespace artcal
