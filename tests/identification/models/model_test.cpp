// Joint errors planted in arms whose readings are made with the equations of forward_kinematics.h: each group of
// parameters brings them back within its own uncertainty, or is refused with what the readings cannot determine of it.
#include "identification/models/model.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/statistics.h"
#include "tests/support/joint_error_sessions.h"
#include "tests/support/random_arm.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

using testing::bar_session;
using testing::nominal_arm;
using testing::options_for;
using testing::true_arm;

/// Error of random lengths of both arms by the independent equations, mm rms, at 27 °C.
double length_rms(const Arm& truth, const Arm& arm) {
  const testing::ArmNumbers<double> true_numbers(truth);
  const testing::ArmNumbers<double> numbers(arm);
  RandomStream random(1, "lengths in the volume");
  double squares = 0.0;
  constexpr int count = 300;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d apart = Eigen::Vector3d::Zero();
    Eigen::Vector3d true_apart = Eigen::Vector3d::Zero();
    for (const double sign : {1.0, -1.0}) {
      const auto q = testing::random_joints(random, truth.joints.size());
      apart += sign * testing::tip_with_errors(numbers, q, 0, 7.0);
      true_apart += sign * testing::tip_with_errors(true_numbers, q, 0, 7.0);
    }
    squares += std::pow(apart.norm() - true_apart.norm(), 2);
  }
  return std::sqrt(squares / count);
}

class JointErrorGroups : public ::testing::TestWithParam<ParameterGroup> {};

TEST_P(JointErrorGroups, ComeBackWithinTheirUncertainty) {
  const Model model{GetParam()};
  const Arm nominal = nominal_arm();
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Arm truth = true_arm(nominal, model, seed);
    const auto bound = bar_session(nominal, truth, seed);
    const Identification result = test::identified(bound, options_for(model));
    EXPECT_LT(result.chi_squared, 1.1 * result.chi_squared_high);
    EXPECT_GT(result.chi_squared, 0.9 * result.chi_squared_low);
    for (const IdentifiedParameter& p : result.parameters) {
      if (p.state != ParameterState::Identified) continue;
      const double off = (p.identified - value(truth, p.parameter)) / p.u;
      EXPECT_LT(std::abs(off), 4.5) << p.parameter.name << ", seed " << seed;
      if (p.parameter.is_joint_error()) {
        sum += off * off;
        ++count;
      }
    }
    IdentifyOptions chain_only = options_for({});
    chain_only.accept_misfit = true;
    const Identification chain = test::identified(bound, chain_only);
    const double with = length_rms(truth, result.arm);
    EXPECT_LT(with, 0.015) << "seed " << seed;
    EXPECT_LT(with, 0.6 * length_rms(truth, chain.arm)) << "seed " << seed;
  }
  EXPECT_GE(count, 3 * 4);
  EXPECT_GT(sum, chi_squared_quantile(1e-3, count));
  EXPECT_LT(sum, 1.3 * chi_squared_quantile(1.0 - 1e-3, count));
}

INSTANTIATE_TEST_SUITE_P(Model, JointErrorGroups,
                         ::testing::Values(ParameterGroup::Eccentricity, ParameterGroup::SecondEccentricity,
                                           ParameterGroup::Gain, ParameterGroup::Coupling, ParameterGroup::Gravity,
                                           ParameterGroup::Thermal),
                         [](const auto& group) { return std::string(name_of(group.param)); });

TEST(Model, AllJointErrorsAtOnceComeBackExactlyWithoutNoise) {
  const Model model{ParameterGroup::Eccentricity, ParameterGroup::SecondEccentricity,
                    ParameterGroup::Gain,         ParameterGroup::Coupling,
                    ParameterGroup::Gravity,      ParameterGroup::Thermal};
  const Arm nominal = nominal_arm();
  const Arm truth = true_arm(nominal, model, 7);
  const auto bound = bar_session(nominal, truth, 7, {0.0, 0.0});
  const Identification result = test::identified(bound, options_for(model));
  for (const IdentifiedParameter& p : result.parameters) {
    if (p.state == ParameterState::Identified) {
      EXPECT_NEAR(p.identified, value(truth, p.parameter), 1e-5 * p.u + 1e-7 * physical_scale(p.parameter, 1000.0))
          << p.parameter.name;
    }
  }
  EXPECT_LT(result.after.overall.maximum, 1e-6);
}

TEST(Model, WhatNoReadingSeesOfAGroupIsHeldAndSaid) {
  const Arm nominal = nominal_arm();
  const auto bound = bar_session(nominal, true_arm(nominal, {ParameterGroup::Gravity}, 1), 1);
  const Identification result = test::identified(bound, options_for({ParameterGroup::Gravity}));
  // Axis 1 is vertical: no weight turns about it.
  const auto first = std::find_if(result.parameters.begin(), result.parameters.end(),
                                  [](const auto& p) { return p.parameter.name == "compliance1"; });
  ASSERT_NE(first, result.parameters.end());
  EXPECT_EQ(first->state, ParameterState::Unidentifiable);
  EXPECT_EQ(first->identified, 0.0);
  EXPECT_EQ(result.free.size(), 21u + 5u);
}

std::string refusal(const test::Bound& bound, const IdentifyOptions& options) {
  const auto result = identify(bound.recording, bound.constraints, options);
  return result ? "accepted" : result.error().text();
}

TEST(Model, AGroupThatCannotBeToldIsRefusedWithItsCombination) {
  const Arm nominal = nominal_arm();
  // One temperature all the time: expansion is the same as longer links.
  auto warm = bar_session(nominal, nominal, 1, {}, 4, 0.0);
  for (Reading& reading : warm.recording.readings) reading.arm_temperature = 25.0;
  const std::string text = refusal(warm, options_for({ParameterGroup::Thermal}));
  EXPECT_THAT(text, HasSubstr("the group thermal was asked for, but these readings identify no parameter of it"));
  EXPECT_THAT(text, HasSubstr("d3 + 3963.5 expansion3 is identifiable, expansion3 alone is not"));
  // Where one link is known, its expansion is identified; the others are fixed.
  IdentifyOptions one_known = options_for({ParameterGroup::Thermal});
  one_known.hold = {"d3"};
  const Identification one = test::identified(warm, one_known);
  std::vector<std::string> fixed;
  for (const FixedMember& member : one.fixed_members) fixed.push_back(member.name);
  EXPECT_THAT(fixed,
              ::testing::UnorderedElementsAre("expansion1", "expansion2", "expansion4", "expansion5", "expansion6"));
  one_known.hold = {"d3", "expansion1", "expansion2", "expansion4", "expansion5", "expansion6"};
  EXPECT_EQ(refusal(warm, one_known), "accepted");
  // The same at the reference temperature: nothing of it is seen.
  for (Reading& reading : warm.recording.readings) reading.arm_temperature = 20.0;
  EXPECT_THAT(refusal(warm, options_for({ParameterGroup::Thermal})), HasSubstr("expansion3 is not identifiable"));
  // A tip off the axis of one probe is the same as other angles of the last joint.
  const std::string tip = refusal(warm, options_for({ParameterGroup::Tip}));
  EXPECT_THAT(tip, HasSubstr("the group tip was asked for"));
  EXPECT_THAT(tip, HasSubstr("lx alone is not identifiable"));
  // Seats say nothing of the tip's radius.
  EXPECT_THAT(refusal(warm, options_for({ParameterGroup::Radius})), HasSubstr("the group radius was asked for"));
}

TEST(Model, AGroupThatMakesNoSenseIsRefused) {
  Arm nominal = nominal_arm();
  nominal.joints[2].mass.reset();
  auto bound = bar_session(nominal, nominal, 1, {}, 3);
  EXPECT_THAT(refusal(bound, options_for({ParameterGroup::Gravity})), HasSubstr("states the mass of its link"));
  EXPECT_THAT(refusal(bound, options_for({ParameterGroup::Hayati})), HasSubstr("no neighbouring axes are parallel"));
  bound.recording.readings[5].arm_temperature = Reading::not_read;
  EXPECT_THAT(refusal(bound, options_for({ParameterGroup::Thermal})), HasSubstr("arm_temperature"));
  IdentifyOptions one = options_for({});
  one.free = {"expansion3"};
  EXPECT_THAT(refusal(bound, one), HasSubstr("arm_temperature"));
  one.free = {"coupling1"};
  EXPECT_THAT(refusal(bound, one), HasSubstr("not a parameter of this arm"));
}

// A group can be had in part, and one joint's error alone.
TEST(Model, MembersCanBeHeldAndFreed) {
  const Arm nominal = nominal_arm();
  const auto bound = bar_session(nominal, nominal, 1, {}, 4);
  IdentifyOptions options = options_for({ParameterGroup::Gain});
  options.hold = {"gain1", "gain6"};
  EXPECT_EQ(test::identified(bound, options).free.size(), 21u + 4u);
  options = options_for({});
  options.free = {"gain3", "cos_q5"};
  EXPECT_EQ(test::identified(bound, options).free.size(), 21u + 2u);
}

// What the arm's file states already is used, and stays as it is where the model does not ask.
TEST(Model, StatedErrorsAreKnown) {
  const Arm nominal = nominal_arm();
  const Arm truth = true_arm(nominal, {ParameterGroup::Eccentricity}, 2);
  auto bound = bar_session(nominal, truth, 2);
  for (std::size_t i = 0; i < truth.joints.size(); ++i) bound.recording.arm.joints[i].errors = truth.joints[i].errors;
  const Identification result = test::identified(bound, options_for({}));
  EXPECT_LT(result.chi_squared, 1.1 * result.chi_squared_high);
  EXPECT_EQ(result.free.size(), 21u);
  EXPECT_EQ(value(result.arm, {"cos_q2", ParameterKind::Cosine1, 1}), truth.joints[1].errors.cosine[0]);
}

// Second and third axis parallel, and then not quite: without β no d is smooth there.
TEST(Model, HayatisAngleBringsBackNearlyParallelAxes) {
  Arm nominal = nominal_arm();
  nominal.joints[1] = {.a = 792.7, .d = 0.0, .theta = 0.0, .alpha = 0.0};
  nominal.joints[2].d = 65.5;
  const Model model{ParameterGroup::Hayati};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Arm truth = true_arm(nominal, model, seed);
    truth.joints[1].d = nominal.joints[1].d;  // one d is enough for two parallel axes
    const auto bound = bar_session(nominal, truth, seed);
    const Identification result = test::identified(bound, options_for(model));
    int betas = 0;
    for (const IdentifiedParameter& p : result.parameters) {
      if (p.state != ParameterState::Identified) continue;
      betas += p.parameter.kind == ParameterKind::Beta ? 1 : 0;
      EXPECT_LT(std::abs(p.identified - value(truth, p.parameter)), 4.5 * p.u) << p.parameter.name;
      EXPECT_NE(p.parameter.name, "d2");
    }
    EXPECT_EQ(betas, 1);
    EXPECT_LT(length_rms(truth, result.arm), 0.015);
  }
}

// Two styli of different length tell what one alone does not: whether a tip is off the axis.
TEST(Model, TipsOffTheAxisComeBack) {
  Arm nominal = nominal_arm();
  nominal.probes[0].name = "short";
  nominal.probes.push_back({"long", {0.0, 0.0, 320.0}, 3.0, true});
  const Model model{ParameterGroup::Tip};
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Arm truth = true_arm(nominal, model, seed);
    const auto bound = bar_session(nominal, truth, seed, {}, 5);
    IdentifyOptions options = options_for(model);
    // Two tips tell two of lx, ly beside θ6 and α6; of the third and fourth they tell the difference.
    options.hold = {"lx:short", "ly:short"};
    const Identification result = test::identified(bound, options);
    int tips = 0;
    for (const IdentifiedParameter& p : result.parameters) {
      tips += p.state == ParameterState::Identified && (p.parameter.name == "lx:long" || p.parameter.name == "ly:long");
    }
    EXPECT_EQ(tips, 2);
    EXPECT_LT(result.chi_squared, 1.1 * result.chi_squared_high);
  }
}

TEST(ModelRequest, ReadsNames) {
  EXPECT_TRUE(model_request("dh")->groups.empty());
  EXPECT_FALSE(model_request("dh")->automatic);
  EXPECT_TRUE(model_request("auto")->automatic);
  const auto both = model_request("dh+gravity+eccentricity2");
  ASSERT_TRUE(both);
  EXPECT_EQ(model_text(both->groups), "dh+gravity+eccentricity2");
  for (const char* wrong : {"", "DH", "gain", "dh+", "dh+gain+", "dh+gain+gain", "dh + gain", "dh+excentricity",
                            "dh+auto", "auto+gain", "dh++gain"}) {
    const auto refused = model_request(wrong);
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().code, ErrorCode::Usage);
  }
  EXPECT_THAT(model_request("dh+excentricity").error().message, HasSubstr("\"excentricity\", expected"));
}

}  // namespace
}  // namespace artcal
