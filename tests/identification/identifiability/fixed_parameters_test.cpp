// The number of fixed parameters is the number of unidentifiable directions, and those that are fixed determine them:
// over random arms of 1 to 8 joints, both conventions and every kind of reading, against ranks and null spaces of an
// independent program (tests/support/independent_rank.h). And the choice where alpha of the last joint is zero, or
// nearly so, which no list of names gets right.
#include "identification/identifiability/fixed_parameters.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/virtual_probing/virtual_probing.h"
#include "core/random.h"
#include "identification/identifiability/coupling.h"
#include "identification/identifiability/selection.h"
#include "tests/support/arms.h"
#include "tests/support/independent_rank.h"

namespace artcal {
namespace {

constexpr double right = std::numbers::pi / 2;

// An arm as people build them, of right angles and links along one axis, or an arm of any shape.
Arm any_arm(RandomStream& random, int joints, Convention convention) {
  Arm arm;
  arm.convention = convention;
  const bool plain = random.uniform(0.0, 1.0) < 0.5;
  for (int i = 0; i < joints; ++i) {
    Joint joint;
    const double links = random.uniform(0.0, 1.0);
    joint.a = plain && links < 0.6 ? 0.0 : random.uniform(50.0, 300.0);
    joint.d = plain && links > 0.8 ? 0.0 : random.uniform(50.0, 300.0);
    joint.theta = plain ? 0.0 : random.uniform(-3.0, 3.0);
    const double turn = random.uniform(0.0, 1.0);
    joint.alpha = !plain       ? random.uniform(0.3, 2.8) * (turn < 0.5 ? 1.0 : -1.0)
                  : turn < 0.2 ? 0.0
                               : (turn < 0.6 ? right : -right);
    arm.joints.push_back(joint);
  }
  Probe probe;
  probe.on_axis = random.uniform(0.0, 1.0) < 0.5;
  probe.tip_in_last = {0.0, 0.0, random.uniform(20.0, 200.0)};
  if (!probe.on_axis) {
    probe.tip_in_last.x() = random.uniform(5.0, 50.0);
    probe.tip_in_last.y() = random.uniform(5.0, 50.0);
  }
  arm.probes.push_back(probe);
  return arm;
}

std::vector<int> fixed_by(const Coupling& coupling, const std::vector<Parameter>& free) {
  std::vector<int> fixed;
  for (int i = 0; i < static_cast<int>(coupling.parameters.size()); ++i) {
    if (find_parameter(free, coupling.parameters[static_cast<std::size_t>(i)].name) < 0) fixed.push_back(i);
  }
  return fixed;
}

class RandomArms : public ::testing::TestWithParam<ReadingKind> {};

TEST_P(RandomArms, RankIsTheNumberOfFreeParametersAndWhatIsFixedSpansTheNullSpace) {
  RandomStream random(17, "random arms", static_cast<std::uint64_t>(GetParam()));
  int looked_at = 0;
  for (int joints = 1; joints <= 8; ++joints) {
    for (const Convention convention : {Convention::Standard, Convention::Modified}) {
      for (int repeat = 0; repeat < 2; ++repeat) {
        const Arm arm = any_arm(random, joints, convention);
        VirtualProbing probing;
        probing.kind = GetParam();
        probing.readings = 60;
        probing.features = 3;
        const VirtualRecording made = probe_virtually(arm, probing);
        if (made.recording.readings.size() != 60) continue;  // an arm of few joints does not get everywhere
        const auto constraints = build_constraints(made.recording, made.artefacts);
        if (!constraints) continue;  // lengths of zero, of an arm with one joint
        const auto selection = select_parameters(arm, {}, {});
        ASSERT_TRUE(selection);
        const auto coupling = analyse_coupling(made.recording, *constraints, arm, coupling_options(*selection));
        if (!coupling) continue;  // readings on a circle determine no centre
        const auto truth = testing::independent_rank(arm, made, GetParam(), coupling->angle_scale);
        if (!truth.is_clear) continue;
        const auto free = free_parameters(*selection, *coupling);
        ASSERT_TRUE(free) << free.error().text();
        ++looked_at;
        SCOPED_TRACE(::testing::Message() << joints << " joints, modified " << (convention == Convention::Modified)
                                          << ", repeat " << repeat);
        ASSERT_EQ(coupling->rank, truth.rank);
        EXPECT_EQ(static_cast<int>(free->size()), truth.rank);
        EXPECT_EQ(coupling->unidentifiable.size(), coupling->parameters.size() - free->size());
        // Each motion that is reported is invisible to the independent program.
        Eigen::MatrixXd motions(truth.scale.size(), 0);
        for (const auto& motion : coupling->unidentifiable) {
          const Eigen::VectorXd x = motion.coefficients.cwiseQuotient(truth.scale).normalized();
          EXPECT_LT((truth.jacobian * x).norm(), 1e-6 * std::max(1.0, truth.values[0]));
          motions.conservativeResize(Eigen::NoChange, motions.cols() + 1);
          motions.rightCols<1>() = x;
        }
        // With the fixed ones known, nothing of the null space is left: it is determined by them, and well.
        const auto fixed = fixed_by(*coupling, *free);
        if (!fixed.empty()) {
          EXPECT_GT(motions.jacobiSvd().singularValues().tail<1>()[0], 1e-4);
          const Eigen::MatrixXd at_fixed = truth.null_space(fixed, Eigen::all);
          EXPECT_GT(at_fixed.jacobiSvd().singularValues().tail<1>()[0], 1e-4);
        }
      }
    }
  }
  EXPECT_GE(looked_at, 15);
}

INSTANTIATE_TEST_SUITE_P(Kinds, RandomArms,
                         ::testing::Values(ReadingKind::BaseCoordinates, ReadingKind::FrameCoordinates,
                                           ReadingKind::Point, ReadingKind::Distance, ReadingKind::Plate,
                                           ReadingKind::Sphere, ReadingKind::UnknownSphere, ReadingKind::Plane,
                                           ReadingKind::LevelPlane, ReadingKind::Length));

Arm arm_with_last_alpha(double alpha) {
  Arm arm = test::gao_arm();
  arm.joints.back().alpha = alpha;
  return arm;
}

std::vector<std::string> fixed_names(const Coupling& coupling) {
  std::vector<std::string> names;
  for (const int index : coupling.fixed()) names.push_back(coupling.parameters[static_cast<std::size_t>(index)].name);
  return names;
}

Coupling coupling_of(const Arm& arm, ReadingKind kind, const Selection& selection) {
  VirtualProbing probing;
  probing.kind = kind;
  const VirtualRecording made = probe_virtually(arm, probing);
  const auto constraints = build_constraints(made.recording, made.artefacts);
  const auto coupling = analyse_coupling(made.recording, *constraints, arm, coupling_options(selection));
  EXPECT_TRUE(coupling) << coupling.error().text();
  return *coupling;
}

// With the last axis along the one before, d6 goes with l, and the tip stays where it is when joint 6 turns: theta6 is
// not seen, a6 is.
TEST(FixedParameters, AlphaOfTheLastJointOfZeroLeavesA6Free) {
  const Arm arm = arm_with_last_alpha(0.0);
  const auto selection = select_parameters(arm, {}, {});
  const Coupling coupling = coupling_of(arm, ReadingKind::BaseCoordinates, *selection);
  EXPECT_EQ(coupling.rank, 21);  // 200 random postures and numpy's SVD say the same
  const auto free = free_parameters(*selection, coupling);
  ASSERT_TRUE(free);
  EXPECT_EQ(free->size(), 21u);
  EXPECT_GE(find_parameter(*free, "a6"), 0);
  EXPECT_THAT(fixed_names(coupling), ::testing::IsSupersetOf({"d6", "theta6"}));
}

// Nearly zero, a6 takes part in an unidentifiable direction, but fixing it would leave theta6 to do its part, by
// 1/(l·alpha6) rad for each mm.
TEST(FixedParameters, NearlyUnidentifiableParametersAreNotLeftFree) {
  for (const double alpha : {1e-6, 1e-4, 1e-2}) {
    const Arm arm = arm_with_last_alpha(alpha);
    const auto selection = select_parameters(arm, {}, {});
    const Coupling coupling = coupling_of(arm, ReadingKind::BaseCoordinates, *selection);
    const auto free = free_parameters(*selection, coupling);
    ASSERT_TRUE(free);
    EXPECT_EQ(static_cast<int>(free->size()), coupling.rank);
    EXPECT_GE(find_parameter(*free, "a6"), 0) << alpha;
    EXPECT_THAT(fixed_names(coupling), ::testing::Not(::testing::Contains("a6"))) << alpha;
  }
}

TEST(FixedParameters, TheFoundingPapersChoiceIsThePreferenceAmongEquals) {
  for (const double length : {20.0, 60.0, 183.5, 400.0}) {
    for (const double alpha : {right, -right, right + 0.01}) {
      Arm arm = arm_with_last_alpha(alpha);
      arm.joints.back().a = 0.05;
      arm.probes.front().tip_in_last.z() = length;
      const auto selection = select_parameters(arm, {}, {});
      const Coupling coupling = coupling_of(arm, ReadingKind::Distance, *selection);
      EXPECT_EQ(fixed_names(coupling), (std::vector<std::string>{"a6", "d6", "d1", "theta1"}))
          << length << ' ' << alpha;
    }
  }
}

TEST(FixedParameters, APairThatTheTipSeparatesMayBeAskedFor) {
  EXPECT_FALSE(select_parameters(arm_with_last_alpha(right), {}, {"a6", "theta6"}));
  EXPECT_TRUE(select_parameters(arm_with_last_alpha(0.0), {}, {"d6", "alpha6"}));
}

// MPE 2018, article 1760190, Table 2: standard Denavit-Hartenberg, mm and degrees. One seat determines no scale, which
// is one motion of all lengths in proportion; beside it, the pairs have two terms and no more.
TEST(FixedParameters, TheScaleIsOneMotionOfAllLengths) {
  Arm arm;
  const double table[6][4] = {{-89.9683, -0.0226, 0.0, 376.5},      {-90.0312, 62.1163, 0.0040, -0.0525},
                              {90.0071, -0.0061, 0.0466, 750.7422}, {-90.0338, 62.1025, -0.0374, 0.0597},
                              {90.0373, 0.0049, 0.0127, 500.5566},  {-90.0, 0.0, -0.0060, 15.0695}};
  constexpr double degree = std::numbers::pi / 180.0;
  for (const auto& [alpha, a, theta, d] : table) {
    arm.joints.push_back({.a = a, .d = d, .theta = theta * degree, .alpha = alpha * degree});
  }
  Probe probe;
  probe.on_axis = true;
  probe.tip_in_last = {0.0, 0.0, 97.8110};
  arm.probes.push_back(probe);
  const auto selection = select_parameters(arm, {}, {});
  for (const int seats : {1, 3}) {
    VirtualProbing probing;
    probing.kind = ReadingKind::Point;
    probing.features = seats;
    const VirtualRecording made = probe_virtually(arm, probing);
    const auto constraints = build_constraints(made.recording, made.artefacts);
    const auto coupling = analyse_coupling(made.recording, *constraints, arm, coupling_options(*selection));
    ASSERT_TRUE(coupling);
    EXPECT_EQ(coupling->rank, 20);
    ASSERT_EQ(coupling->unidentifiable.size(), 5u);
    EXPECT_EQ(coupling->scale, ScaleState::Unidentifiable);
    std::map<std::string, int> terms;
    for (const auto& motion : coupling->unidentifiable) {
      terms[coupling->parameters[static_cast<std::size_t>(motion.leading)].name] =
          static_cast<int>((motion.coefficients.array() != 0.0).count());
    }
    EXPECT_EQ(terms["a6"], 2);
    EXPECT_EQ(terms["d6"], 2);
    EXPECT_EQ(terms["d1"], 1);
    EXPECT_EQ(terms["theta1"], 1);
    // The last one: every length that is not zero, but for d1, which nothing tells whatever the scale, in proportion.
    const auto& scale = coupling->unidentifiable.back();
    const double expansion_factor = 1.0 / value(arm, coupling->parameters[static_cast<std::size_t>(scale.leading)]);
    for (Eigen::Index i = 0; i < scale.coefficients.size(); ++i) {
      const Parameter& parameter = coupling->parameters[static_cast<std::size_t>(i)];
      const double expected =
          parameter.is_length() && parameter.name != "d1" ? expansion_factor * value(arm, parameter) : 0.0;
      EXPECT_NEAR(scale.coefficients[i], expected, 1e-6) << parameter.name;
    }
  }
}

}  // namespace
}  // namespace artcal
