// What each kind of reading cannot determine: every row of the project's table of unidentifiable parameters, on the arm
// of Gao 2013. The expected ranks and equations were computed by an independent program.
#include "identification/identifiability/coupling.h"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/virtual_probing/virtual_probing.h"
#include "identification/identifiability/unidentifiable_text.h"
#include "tests/support/arms.h"

namespace artcal {
namespace {

constexpr double tip = 183.5;

Coupling analyse(ReadingKind kind, int features = 4, const CouplingOptions& options = {}, std::uint64_t seed = 1) {
  const Arm arm = test::gao_arm();
  VirtualProbing probing;
  probing.kind = kind;
  probing.features = features;
  probing.seed = seed;
  const VirtualRecording made = probe_virtually(arm, probing);
  const auto constraints = build_constraints(made.recording, made.artefacts);
  EXPECT_TRUE(constraints) << constraints.error().text();
  const auto coupling = analyse_coupling(made.recording, *constraints, arm, options);
  EXPECT_TRUE(coupling) << coupling.error().text();
  return *coupling;
}

// An unidentifiable motion as {parameter: coefficient}, those that take part only.
std::map<std::string, double> equation(const Coupling& coupling, const std::string& fixed) {
  for (const auto& motion : coupling.unidentifiable) {
    if (coupling.parameters[motion.leading].name != fixed) continue;
    std::map<std::string, double> result;
    for (Eigen::Index i = 0; i < motion.coefficients.size(); ++i) {
      if (motion.coefficients[i] != 0.0) result[coupling.parameters[i].name] = motion.coefficients[i];
    }
    return result;
  }
  return {};
}

std::vector<std::string> fixed_names(const Coupling& coupling) {
  std::vector<std::string> names;
  for (const int index : coupling.fixed()) names.push_back(coupling.parameters[index].name);
  return names;
}

void expect_equation(const Coupling& coupling, const std::string& fixed,
                     const std::map<std::string, double>& expected) {
  const auto found = equation(coupling, fixed);
  ASSERT_EQ(found.size(), expected.size()) << fixed;
  for (const auto& [name, coefficient] : expected) {
    ASSERT_TRUE(found.contains(name)) << fixed << " lacks " << name;
    EXPECT_NEAR(found.at(name), coefficient, 1e-6 * std::abs(coefficient)) << fixed << ": " << name;
  }
}

void expect_wrist_pairs(const Coupling& coupling) {
  expect_equation(coupling, "a6", {{"a6", 1.0}, {"theta6", -1.0 / tip}});
  expect_equation(coupling, "d6", {{"d6", 1.0}, {"alpha6", 1.0 / tip}});
}

void expect_base(const Coupling& coupling) {
  expect_equation(coupling, "d1", {{"d1", 1.0}});
  expect_equation(coupling, "theta1", {{"theta1", 1.0}});
}

void expect_scale(const Coupling& coupling) {
  EXPECT_EQ(coupling.scale, ScaleState::Unidentifiable);
  expect_equation(coupling, "d2",
                  {{"d2", 1.0}, {"d3", 792.7 / 65.5}, {"d4", 1.0}, {"d5", 883.2 / 65.5}, {"l", 183.5 / 65.5}});
}

TEST(Coupling, BaseCoordinatesLoseTheTwoWristPairs) {
  const Coupling coupling = analyse(ReadingKind::BaseCoordinates);
  EXPECT_EQ(coupling.parameters.size(), 25u);
  EXPECT_EQ(coupling.rank, 23);
  EXPECT_EQ(fixed_names(coupling), (std::vector<std::string>{"a6", "d6"}));
  expect_wrist_pairs(coupling);
  EXPECT_EQ(coupling.scale, ScaleState::Determined);
}

TEST(Coupling, UnknownFrameAlsoLosesTheBase) {
  const Coupling coupling = analyse(ReadingKind::FrameCoordinates);
  EXPECT_EQ(coupling.rank, 21);
  expect_wrist_pairs(coupling);
  expect_base(coupling);
  EXPECT_NE(coupling.scale, ScaleState::Unidentifiable);
}

TEST(Coupling, DistancesAlsoLoseTheBase) {
  const Coupling coupling = analyse(ReadingKind::Distance);
  EXPECT_EQ(coupling.rank, 21);
  expect_wrist_pairs(coupling);
  expect_base(coupling);
  EXPECT_NE(coupling.scale, ScaleState::Unidentifiable);
}

TEST(Coupling, OneToSixUnknownPointsLoseTheScaleToo) {
  for (int points = 1; points <= 6; ++points) {
    const Coupling coupling = analyse(ReadingKind::Point, points);
    EXPECT_EQ(coupling.rank, 20) << points;
    expect_wrist_pairs(coupling);
    expect_base(coupling);
    expect_scale(coupling);
  }
}

TEST(Coupling, BallsOfKnownRadiusKeepTheScaleButWeakly) {
  const Coupling coupling = analyse(ReadingKind::Sphere);
  EXPECT_EQ(coupling.rank, 21);
  expect_wrist_pairs(coupling);
  expect_base(coupling);
  EXPECT_EQ(coupling.scale, ScaleState::Weak);
  EXPECT_NEAR(coupling.singular_values[20] / coupling.singular_values[0], 0.009, 0.006);
}

TEST(Coupling, APlateAtUnknownPosesLosesTheBaseOnly) {
  const Coupling coupling = analyse(ReadingKind::Plate);
  EXPECT_EQ(coupling.rank, 21);
  EXPECT_EQ(fixed_names(coupling), (std::vector<std::string>{"a6", "d6", "d1", "theta1"}));
  expect_wrist_pairs(coupling);
  expect_base(coupling);
  EXPECT_NE(coupling.scale, ScaleState::Unidentifiable);
}

TEST(Coupling, BallsOfUnknownRadiusLoseTheScaleToo) {
  for (const int balls : {1, 4}) {
    const Coupling coupling = analyse(ReadingKind::UnknownSphere, balls);
    EXPECT_EQ(coupling.rank, 20) << balls;
    expect_wrist_pairs(coupling);
    expect_base(coupling);
    expect_scale(coupling);
  }
}

TEST(Coupling, UnknownPlanesLoseTheScaleToo) {
  for (const int planes : {1, 2, 4}) {  // one of them is oblique, two are not parallel
    const Coupling coupling = analyse(ReadingKind::Plane, planes);
    EXPECT_EQ(coupling.rank, 20) << planes;
    expect_wrist_pairs(coupling);
    expect_base(coupling);
    expect_scale(coupling);
  }
}

// a1 moves the arm along them. So does d2, which the scale no longer needs to move: d3 tells of it.
TEST(Coupling, PlanesPerpendicularToTheFirstAxisLoseSeven) {
  for (const int planes : {1, 3}) {
    const Coupling coupling = analyse(ReadingKind::LevelPlane, planes);
    EXPECT_EQ(coupling.rank, 18) << planes;
    EXPECT_EQ(coupling.unidentifiable.size(), 7u);
    expect_wrist_pairs(coupling);
    expect_base(coupling);
    expect_equation(coupling, "a1", {{"a1", 1.0}});
    expect_equation(coupling, "d2", {{"d2", 1.0}});
    EXPECT_EQ(coupling.scale, ScaleState::Unidentifiable);
    expect_equation(coupling, "d3", {{"d3", 1.0}, {"d4", 65.5 / 792.7}, {"d5", 883.2 / 792.7}, {"l", 183.5 / 792.7}});
  }
}

TEST(Coupling, MeasuredLengthsToUnknownAnchorsLoseTheBaseOnly) {
  const Coupling coupling = analyse(ReadingKind::Length);
  EXPECT_EQ(coupling.rank, 21);
  expect_wrist_pairs(coupling);
  expect_base(coupling);
  EXPECT_EQ(coupling.scale, ScaleState::Determined);
}

TEST(Coupling, TheSameEverywhereOnTheSeed) {
  for (const std::uint64_t seed : {2, 3, 4}) {
    EXPECT_EQ(analyse(ReadingKind::BaseCoordinates, 4, {}, seed).rank, 23);
    EXPECT_EQ(analyse(ReadingKind::Distance, 4, {}, seed).rank, 21);
    EXPECT_EQ(analyse(ReadingKind::Point, 3, {}, seed).rank, 20);
    EXPECT_EQ(analyse(ReadingKind::Sphere, 4, {}, seed).rank, 21);
    EXPECT_EQ(analyse(ReadingKind::Plate, 4, {}, seed).rank, 21);
    EXPECT_EQ(analyse(ReadingKind::UnknownSphere, 2, {}, seed).rank, 20);
    EXPECT_EQ(analyse(ReadingKind::Plane, 1, {}, seed).rank, 20);
    EXPECT_EQ(analyse(ReadingKind::LevelPlane, 1, {}, seed).rank, 18);
  }
}

// With lx and ly free the wrist loses four: of a6, d6, theta6, alpha6, lx, ly, lz only three count.
TEST(Coupling, ATipOffTheAxisLosesFourInTheWrist) {
  Arm arm = test::gao_arm();
  arm.probes.front().on_axis = false;
  arm.probes.front().tip_in_last = {3.0, -2.0, 183.5};
  VirtualProbing probing;
  const VirtualRecording made = probe_virtually(arm, probing);
  const auto constraints = build_constraints(made.recording, made.artefacts);
  const auto coupling = analyse_coupling(made.recording, *constraints, arm);
  ASSERT_TRUE(coupling);
  EXPECT_EQ(coupling->parameters.size(), 27u);
  EXPECT_EQ(coupling->rank, 23);
  EXPECT_EQ(fixed_names(*coupling), (std::vector<std::string>{"a6", "d6", "alpha6", "theta6"}));
}

TEST(Coupling, AKnownLengthKeepsTheScale) {
  CouplingOptions options;
  options.not_asked = {"l"};
  EXPECT_NE(analyse(ReadingKind::Point, 4, options).scale, ScaleState::Unidentifiable);
}

// The radius of the tip is known; asked about, it goes with every radius and place that is not. With balls of one
// size it also takes up the growth of the ball: known radii then tell no scale.
TEST(Coupling, TheTipsRadiusIsTold) {
  CouplingOptions options;
  options.beside_asked = {"radius"};
  const Coupling balls = analyse(ReadingKind::Sphere, 4, options);
  EXPECT_EQ(balls.parameters.back().name, "radius");
  EXPECT_EQ(balls.rank, 21);
  EXPECT_EQ(balls.scale, ScaleState::Unidentifiable);
  expect_equation(balls, "d2",
                  {{"d2", 1.0},
                   {"d3", 792.7 / 65.5},
                   {"d4", 1.0},
                   {"d5", 883.2 / 65.5},
                   {"l", 183.5 / 65.5},
                   {"radius", 12.7 / 65.5}});
  for (const ReadingKind kind : {ReadingKind::UnknownSphere, ReadingKind::Plane, ReadingKind::Point}) {
    const Coupling none = analyse(kind, 4, options);
    EXPECT_EQ(none.rank, 20);
    expect_equation(none, "radius", {{"radius", 1.0}});
    EXPECT_EQ(none.scale, ScaleState::Unidentifiable);
  }
}

TEST(Coupling, TheOtherMemberOfAPairIsHeldOnRequest) {
  CouplingOptions options;
  options.rather_free = {"a6", "d6"};
  const Coupling coupling = analyse(ReadingKind::BaseCoordinates, 4, options);
  EXPECT_EQ(fixed_names(coupling), (std::vector<std::string>{"alpha6", "theta6"}));
  expect_equation(coupling, "theta6", {{"theta6", 1.0}, {"a6", -tip}});
}

TEST(Coupling, AnArmOutOfAllProportionHasAWrongUnit) {
  const VirtualRecording made = probe_virtually(test::gao_arm(), {});
  const auto constraints = build_constraints(made.recording, made.artefacts);
  for (const double factor : {1e-3, 1e3, 1e200}) {  // metres taken for mm, mm for metres, nonsense
    Arm arm = test::gao_arm();
    for (auto& joint : arm.joints) joint.d *= factor;
    arm.probes.front().tip_in_last *= factor;
    const auto coupling = analyse_coupling(made.recording, *constraints, arm);
    ASSERT_FALSE(coupling) << factor;
    EXPECT_EQ(coupling.error().code, ErrorCode::BadInput);
    EXPECT_THAT(coupling.error().message, ::testing::HasSubstr("is a unit of its file wrong?"));
  }
}

TEST(Coupling, InWords) {
  const Coupling point = analyse(ReadingKind::Point);
  std::vector<std::string> sentences;
  for (const auto& motion : point.unidentifiable) sentences.push_back(unidentifiable_in_words(point, motion));
  EXPECT_EQ(sentences, (std::vector<std::string>{"theta6 + a6/183.5 is identifiable, a6 alone is not",
                                                 "alpha6 - d6/183.5 is identifiable, d6 alone is not",
                                                 "d1 is not identifiable", "theta1 is not identifiable",
                                                 "d2 + 12.102 d3 + d4 + 13.484 d5 + 2.8015 l change together without "
                                                 "any effect, d2 alone is not identifiable"}));
  const Coupling sphere = analyse(ReadingKind::Sphere);
  ASSERT_FALSE(sphere.weak.empty());
  EXPECT_THAT(weak_in_words(sphere, sphere.weak.front()), ::testing::HasSubstr("mostly the scale of all lengths"));
}

}  // namespace
}  // namespace artcal
