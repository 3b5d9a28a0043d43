// What becomes of a group of model errors of which readings determine some members only: these are fixed and said, and
// the others come back as they were planted.
#include "identification/models/group_fit.h"
#include "core/normal_vector.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/virtual_probing/virtual_probing.h"
#include "tests/support/joint_error_sessions.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using testing::newton_metre;
using Reason = FixedMember::Reason;

const FixedMember* fixed(const Identification& result, const std::string& name) {
  const auto found = std::find_if(result.fixed_members.begin(), result.fixed_members.end(),
                                  [&](const FixedMember& member) { return member.name == name; });
  return found == result.fixed_members.end() ? nullptr : &*found;
}

/// Coordinates of random postures in which joint 3 stands still, by the equations of forward_kinematics.h.
test::Bound still_joint(const Arm& nominal, const Arm& truth, double noise) {
  VirtualRecording made = probe_virtually(truth, {});
  made.recording.arm = nominal;
  made.recording.joints.row(2).setConstant(0.7);
  const testing::ArmNumbers<double> numbers(truth);
  RandomStream random(1, "noise");
  for (std::size_t i = 0; i < made.recording.readings.size(); ++i) {
    const auto q = made.recording.joints.col(static_cast<Eigen::Index>(i));
    made.recording.readings[i].reference =
        testing::tip_with_errors(numbers, std::vector<double>(q.begin(), q.end()), 0, 0.0) +
        noise * normal_vector(random);
  }
  return test::bind(std::move(made.recording), std::move(made.artefacts));
}

// The gain of a joint that stands still is the same as its encoder's zero: only their sum is seen.
TEST(GroupFit, AMemberThatIsNotIdentifiableIsFixedAndTheOthersComeBack) {
  const Arm nominal = testing::nominal_arm();
  const Arm truth = testing::true_arm(nominal, {ParameterGroup::Gain}, 3);
  const auto bound = still_joint(nominal, truth, 0.01);
  IdentifyOptions options;
  options.noise.reading = 0.01;
  options.leave_out = false;
  options.model = {ParameterGroup::Gain};
  const Identification result = test::identified(bound, options);
  ASSERT_EQ(result.fixed_members.size(), 1u);
  EXPECT_EQ(result.fixed_members.front().name, "gain3");
  EXPECT_EQ(result.fixed_members.front().reason, Reason::NotIdentifiable);
  EXPECT_THAT(result.fixed_members.front().why, HasSubstr("gain3 alone is not"));
  int gains = 0;
  for (const IdentifiedParameter& p : result.parameters) {
    if (p.parameter.kind == ParameterKind::Gain && p.state == ParameterState::Identified) {
      ++gains;
      EXPECT_NEAR(p.identified, value(truth, p.parameter), 4.5 * p.u) << p.parameter.name;
    }
  }
  EXPECT_EQ(gains, 5);
  EXPECT_LT(result.chi_squared, 1.1 * result.chi_squared_high);
}

/// A bar read by an arm whose joints 2 and 4 give way to weight, while joint 3 is lifted by a spring that nobody
/// modelled.
test::Bound lifted(const Arm& nominal, Arm& truth) {
  truth = testing::true_arm(nominal, {}, 4);
  const double arcsec_per_newton_metre = units::arcsecond / newton_metre;
  truth.joints[1].errors.compliance = 8.0 * arcsec_per_newton_metre;
  truth.joints[2].errors.compliance = -10.0 * arcsec_per_newton_metre;
  truth.joints[3].errors.compliance = 6.0 * arcsec_per_newton_metre;
  return testing::bar_session(nominal, truth, 4);
}

TEST(GroupFit, AComplianceBelowZeroIsNoResult) {
  const Arm nominal = testing::nominal_arm();
  Arm truth;
  const auto bound = lifted(nominal, truth);
  const Identification result = test::identified(bound, testing::options_for({ParameterGroup::Gravity}));
  const FixedMember* third = fixed(result, "compliance3");
  ASSERT_NE(third, nullptr);
  EXPECT_EQ(third->reason, Reason::BelowZero);
  EXPECT_NEAR(third->estimate, truth.joints[2].errors.compliance, 4.5 * third->u);
  EXPECT_THAT(third->why, HasSubstr("below zero"));
  for (const IdentifiedParameter& p : result.parameters) {
    if (p.parameter.kind == ParameterKind::Compliance) {
      EXPECT_GE(p.identified, 0.0) << p.parameter.name;
    }
  }
  EXPECT_GT(result.arm.joints[1].errors.compliance, 0.0);
  // Asked for by its name it is not fixed but refused.
  IdentifyOptions options = testing::options_for({});
  options.accept_misfit = true;
  options.free = {"compliance3"};
  const auto refused = identify(bound.recording, bound.constraints, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::NoSolution);
  EXPECT_THAT(refused.error().message, HasSubstr("compliance3 = -"));
}

// Neither is it named as a cause of what the residuals hold.
TEST(GroupFit, AWeightThatLiftsIsNoCause) {
  const Arm nominal = testing::nominal_arm();
  Arm truth = testing::true_arm(nominal, {}, 4);
  truth.joints[1].errors.compliance = -8.0 * units::arcsecond / newton_metre;
  const auto bound = testing::bar_session(nominal, truth, 4);
  IdentifyOptions options = testing::options_for({});
  options.accept_misfit = true;  // the residuals are to be looked at, however large
  const ModelStudy study = test::identified(bound, options).model_study;
  EXPECT_TRUE(study.done);
  for (const ModelFinding& finding : study.findings) {
    EXPECT_FALSE(finding.effect == Effect::Gravity && finding.joint == 1) << in_words(finding);
  }
  EXPECT_TRUE(!study.findings.empty() || study.implausible > 0);
  EXPECT_NE(warning_of(study), "");
  truth.joints[1].errors.compliance *= -1.0;
  const auto sagging = testing::bar_session(nominal, truth, 4);
  const ModelStudy sag = test::identified(sagging, options).model_study;
  ASSERT_FALSE(sag.findings.empty());
  EXPECT_EQ(sag.findings.front().effect, Effect::Gravity);
  EXPECT_EQ(sag.findings.front().joint, 1);
}

// Real readings (tests/reference/mukca-panda): the last joint's compliance is hardly determined, its weight being small
// and near its axis, and used to refuse the group of all the others.
TEST(GroupFit, TheLastJointDoesNotSinkGravityOfTheOthers) {
  test::Bound bound = test::read_bound(test::example("two-socket-bar/recording.toml"));
  // Masses of the links, kg; in proportion is enough.
  const double masses[] = {4.97, 0.65, 3.23, 3.59, 1.23, 1.67, 1.47};
  for (std::size_t i = 0; i < 7; ++i) bound.recording.arm.joints[i].mass = masses[i];
  IdentifyOptions options;
  options.leave_out = false;
  options.model = {ParameterGroup::Gravity};
  const Identification result = test::identified(bound, options);
  EXPECT_NE(fixed(result, "compliance7"), nullptr);
  for (const IdentifiedParameter& p : result.parameters) {
    if (p.parameter.kind != ParameterKind::Compliance) continue;
    EXPECT_GE(p.identified, 0.0) << p.parameter.name;
    if (p.parameter.name == "compliance3" || p.parameter.name == "compliance4") {
      EXPECT_EQ(p.state, ParameterState::Identified);
      EXPECT_GT(p.identified, 5.0 * p.u);
    }
  }
}

}  // namespace
}  // namespace artcal
