// What each kind of reading cannot tell: every row of the project's table of lost parameters, on the arm
// of Gao 2013. The expected ranks and equations were computed by an independent program.
#include "identification/coupling.h"

#include <map>
#include "identification/start.h"

#include <gtest/gtest.h>

#include "acquisition/recording_file.h"
#include "artefacts/virtual_probing.h"
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

// A lost motion as {parameter: coefficient}, those that take part only.
std::map<std::string, double> equation(const Coupling& coupling, const std::string& held) {
  for (const auto& motion : coupling.lost) {
    if (coupling.parameters[motion.leading].name != held) continue;
    std::map<std::string, double> result;
    for (Eigen::Index i = 0; i < motion.coefficients.size(); ++i) {
      if (motion.coefficients[i] != 0.0) result[coupling.parameters[i].name] = motion.coefficients[i];
    }
    return result;
  }
  return {};
}

std::vector<std::string> held_names(const Coupling& coupling) {
  std::vector<std::string> names;
  for (const int index : coupling.held()) names.push_back(coupling.parameters[index].name);
  return names;
}

void expect_equation(const Coupling& coupling, const std::string& held, const std::map<std::string, double>& expected) {
  const auto found = equation(coupling, held);
  ASSERT_EQ(found.size(), expected.size()) << held;
  for (const auto& [name, coefficient] : expected) {
    ASSERT_TRUE(found.contains(name)) << held << " lacks " << name;
    EXPECT_NEAR(found.at(name), coefficient, 1e-6 * std::abs(coefficient)) << held << ": " << name;
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
  EXPECT_EQ(coupling.scale, ScaleState::Lost);
  expect_equation(coupling, "d2",
                  {{"d2", 1.0}, {"d3", 792.7 / 65.5}, {"d4", 1.0}, {"d5", 883.2 / 65.5}, {"l", 183.5 / 65.5}});
}

TEST(Coupling, BaseCoordinatesLoseTheTwoWristPairs) {
  const Coupling coupling = analyse(ReadingKind::BaseCoordinates);
  EXPECT_EQ(coupling.parameters.size(), 25u);
  EXPECT_EQ(coupling.rank, 23);
  EXPECT_EQ(held_names(coupling), (std::vector<std::string>{"a6", "d6"}));
  expect_wrist_pairs(coupling);
  EXPECT_EQ(coupling.scale, ScaleState::Determined);
}

TEST(Coupling, UnknownFrameAlsoLosesTheBase) {
  const Coupling coupling = analyse(ReadingKind::FrameCoordinates);
  EXPECT_EQ(coupling.rank, 21);
  expect_wrist_pairs(coupling);
  expect_base(coupling);
  EXPECT_NE(coupling.scale, ScaleState::Lost);
}

TEST(Coupling, DistancesAlsoLoseTheBase) {
  const Coupling coupling = analyse(ReadingKind::Distance);
  EXPECT_EQ(coupling.rank, 21);
  expect_wrist_pairs(coupling);
  expect_base(coupling);
  EXPECT_NE(coupling.scale, ScaleState::Lost);
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
  for (auto& w : coupling.weak) {
    printf("weak %g share %g:", w.singular_value, w.share_of_scale);
    for (int i = 0; i < 25; ++i) printf(" %s %.3g", coupling.parameters[i].name.c_str(), w.motion.coefficients[i]);
    printf("\n");
  }
  for (double s : coupling.singular_values) printf("%g ", s);
  EXPECT_NEAR(coupling.singular_values[20] / coupling.singular_values[0], 0.009, 0.006);
}

TEST(Coupling, MeasuredLengthsToUnknownAnchorsLoseTheBaseOnly) {
  const Coupling coupling = analyse(ReadingKind::Length);
  EXPECT_EQ(coupling.rank, 21);
  expect_wrist_pairs(coupling);
  expect_base(coupling);
  EXPECT_EQ(coupling.scale, ScaleState::Determined);
}

TEST(Coupling, PandaReadingsTellTwentyFiveOfThirtyOne) {
  auto recording = read_recording(test::example("two-socket-bar/recording.toml"));
  ASSERT_TRUE(recording) << recording.error().text();
  const auto constraints = read_constraints(*recording);
  ASSERT_TRUE(constraints) << constraints.error().text();
  CouplingOptions options;
  options.angle_scale = 1000.0;
  const auto coupling = analyse_coupling(*recording, *constraints,
                                         *arm_with_fitted_tips(*recording, *constraints, recording->arm, {}), options);
  ASSERT_TRUE(coupling) << coupling.error().text();
  EXPECT_EQ(coupling->parameters.size(), 31u);
  EXPECT_EQ(coupling->rank, 25);
  for (double s : coupling->singular_values) printf("%g ", s);
  printf("\n");
  for (auto& n : held_names(*coupling)) {
    printf("%s:", n.c_str());
    for (auto& [k, v] : equation(*coupling, n)) printf(" %s %g", k.c_str(), v);
    printf("\n");
  }
  for (auto& w : coupling->weak) {
    printf("weak %g:", w.singular_value);
    for (int i = 0; i < 31; ++i) printf(" %s %.3g", coupling->parameters[i].name.c_str(), w.motion.coefficients[i]);
    printf("\n");
  }
}

}  // namespace
}  // namespace artcal
