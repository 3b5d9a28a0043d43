// Against whole identifications of the other placements, which know nothing of the solution for all.
#include "identification/cross_validation/placement_refit.h"

#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "artefacts/simulation/possible_session.h"
#include "artefacts/simulation/simulate.h"
#include "identification/problem/preparation.h"
#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

namespace artcal {
namespace {

Artefact balls(const std::string& name, int count, double u_at, double u_radius) {
  Artefact artefact;
  artefact.name = name;
  for (int i = 0; i < count; ++i) {
    CertifiedFeature ball = testing::feature_of(std::to_string(i), FeatureKind::Sphere);
    ball.radius = 11.0;
    ball.u_radius = u_radius;
    if (u_at > 0.0) {
      ball.at = Eigen::Vector3d(90.0 * (i % 4), 80.0 * (i / 4), 5.0 * (i % 3));
      ball.u_at = u_at;
    }
    artefact.features.push_back(ball);
  }
  return artefact;
}

// A plate: its balls are eliminated before its poses. A bar in more placements than it has balls: the other way round.
Artefact plate() { return balls("plate", 12, 5e-4, 3e-4); }
Artefact bar() {
  Artefact artefact = balls("bar", 2, 0.0, 3e-4);
  artefact.distances = {{0, 1, 500.0, 3e-4}};
  return artefact;
}

Artefact seats() {
  Artefact artefact;
  artefact.name = "seats";
  for (int i = 0; i < 3; ++i) {
    artefact.features.push_back(testing::feature_of(std::to_string(i), FeatureKind::Point));
  }
  artefact.distances = {{0, 1, 300.0, 1e-3}, {1, 2, 250.0, 1e-3}};
  return artefact;
}

test::Bound session(const Artefact& artefact, int placements, int readings) {
  Arm arm = test::gao_arm();
  arm.probes.front().radius = 3.0;
  auto simulation = simulate(possible_session(arm, artefact, {placements, readings, 5}));
  if (!simulation) throw std::runtime_error(simulation.error().text());
  RandomStream random(11, "noise");
  for (double& q : simulation->recording.joints.reshaped()) {
    q += 5.0 / 3600.0 * std::numbers::pi / 180.0 * random.normal();
  }
  return test::bind(std::move(simulation->recording), {artefact});
}

/// What a session is to show beside that refits are identifications of the other placements.
struct Demand {
  int max_left = 0;            ///< placements left to the whole identification, at most
  std::optional<bool> expand;  ///< by the expansion of the gradient
  int min_expanded = 0;        ///< placements that it was enough for, at least
  double tolerance = 2e-8;     ///< mm
};

void expect_as_identified_anew(const test::Bound& bound, const Noise& noise, const Demand& demand = {}) {
  IdentifyOptions options;
  options.noise = noise;
  const auto prepared = prepare(bound.recording, bound.constraints, options, Alignment::None);
  ASSERT_TRUE(prepared) << prepared.error().text();
  const auto fit = fit_arm(bound.recording, bound.constraints, prepared->start, prepared->free, noise, {});
  ASSERT_TRUE(fit) << fit.error().text();
  const System system = make_system(bound.recording, bound.constraints, fit->arm, prepared->free);
  const auto refit = PlacementRefit::of(system, *fit, bound.recording, noise, 2, demand.expand);
  ASSERT_TRUE(refit) << refit.error().text();
  std::set<Placement> placements;
  int left_to_the_whole_identification = 0;
  int expanded = 0;
  for (const FeatureConstraint& feature : bound.constraints.features) {
    placements.insert({feature.artefact, feature.placement});
  }
  for (const Placement& placement : placements) {
    std::vector<bool> left_out;
    for (const FeatureConstraint& feature : bound.constraints.features) {
      left_out.push_back(Placement{feature.artefact, feature.placement} == placement);
    }
    const Constraints rest = without_features(bound.constraints, left_out);
    const auto anew = fit_arm(bound.recording, rest, fit->arm, prepared->free, noise, {Loss::None, 100, 1e-9});
    ASSERT_TRUE(anew) << anew.error().text();
    const auto found = refit->without(placement);
    if (!found) {
      ++left_to_the_whole_identification;
      continue;
    }
    expanded += found->expanded ? 1 : 0;
    double moved = 0.0;
    for (int i = 0; i < system.arm_size(); ++i) {
      const Parameter& parameter = prepared->free[i];
      EXPECT_NEAR(value(found->arm, parameter) / system.scale[i], value(anew->arm, parameter) / system.scale[i],
                  demand.tolerance)
          << parameter.name << " without placement " << placement.second;  // mm
      moved = std::max(moved, std::abs(value(found->arm, parameter) - value(fit->arm, parameter)) / system.scale[i]);
    }
    EXPECT_GT(moved, 1e-4) << "nothing was left out";
  }
  EXPECT_LE(left_to_the_whole_identification, demand.max_left);
  EXPECT_GE(expanded, demand.min_expanded);
}

Noise of_a_reading(double sigma) {
  Noise noise;
  noise.reading = sigma;
  return noise;
}

TEST(PlacementRefit, OfAPlateIsTheIdentificationOfTheOtherPlacements) {
  expect_as_identified_anew(session(plate(), 4, 60), of_a_reading(0.02));
}

TEST(PlacementRefit, OfABarInManyPlacementsIsTheIdentificationOfTheOthers) {
  expect_as_identified_anew(session(bar(), 14, 30), of_a_reading(0.02), {2, {}, 0});
}

TEST(PlacementRefit, FollowsWeightsThatDependOnThePosture) {
  Noise noise;
  noise.encoder = 5.0 / 3600.0 * std::numbers::pi / 180.0;
  noise.probing = 0.002;
  expect_as_identified_anew(session(plate(), 4, 60), noise);
}

TEST(PlacementRefit, ByTheExpansionIsTheIdentificationOfTheOthers) {
  expect_as_identified_anew(session(bar(), 40, 24), of_a_reading(0.02), {2, true, 30});
}

TEST(PlacementRefit, ByTheExpansionFollowsWeightsThatDependOnThePosture) {
  Noise noise;
  noise.encoder = 5.0 / 3600.0 * std::numbers::pi / 180.0;
  noise.probing = 0.002;
  expect_as_identified_anew(session(bar(), 40, 24), noise, {2, true, 30, 3e-8});
}

TEST(PlacementRefit, OfSeatsWhoseReadingsMustBeMovedForTheRank) {
  expect_as_identified_anew(session(seats(), 6, 60), of_a_reading(0.02));
}

TEST(PlacementRefit, LeavesTheOnlyPlacementToTheWholeIdentification) {
  const test::Bound bound = session(plate(), 1, 120);
  const Arm& arm = bound.recording.arm;
  const std::vector<Parameter> free{parameters_of(arm)[1]};
  const auto fit = fit_arm(bound.recording, bound.constraints, arm, free, of_a_reading(0.02), {});
  ASSERT_TRUE(fit) << fit.error().text();
  const System system = make_system(bound.recording, bound.constraints, fit->arm, free);
  const auto refit = PlacementRefit::of(system, *fit, bound.recording, of_a_reading(0.02));
  ASSERT_TRUE(refit) << refit.error().text();
  EXPECT_FALSE(refit->without({bound.constraints.features[0].artefact, bound.constraints.features[0].placement}));
}

}  // namespace
}  // namespace artcal
