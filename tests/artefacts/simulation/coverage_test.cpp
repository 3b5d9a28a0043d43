// Do 95 % intervals hold the truth? The short version of bench/coverage.cpp: one simulated session, its readings with
// other noise and its certificate with another error sixty times.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "artefacts/simulation/simulate.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/units.h"
#include "identification/identify.h"
#include "identification/uncertainty/uncertain_arm.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/plans.h"

namespace artcal {
namespace {

constexpr int repetitions = 60;
constexpr double k_95 = 1.959964;
constexpr double encoder_noise = 2.0 * units::arcsecond;
constexpr double u_of_length = 0.004;  // mm, as much as the readings leave open

Simulation session(SimulationPlan& plan) {
  plan = testing::plan_for(testing::bar_of(FeatureKind::Point), 12);
  plan.nominal.probes[0].on_axis = true;
  plan.nominal.probes[0].tip_in_last = {0.0, 0.0, 183.5};
  plan.arm.arm = plan.nominal;
  plan.errors = {0.3, 2e-3, 0.0, 0.0, {"a6", "d6", "d1", "theta1"}};
  plan.placements.clear();
  plan.probings[0].placements.clear();
  for (int p = 0; p < 6; ++p) {
    PlannedPlacement placement;
    placement.name = std::to_string(p);
    plan.placements.push_back(placement);
    plan.probings[0].placements.push_back(p);
  }
  auto made = simulate(plan);
  if (!made) throw std::runtime_error(made.error().text());
  return std::move(*made);
}

double true_length(const testing::ArmNumbers<double>& truth, const std::array<Eigen::VectorXd, 2>& q) {
  const auto tip = [&](const Eigen::VectorXd& at) {
    return testing::tip_in_base(truth, std::vector<double>(at.begin(), at.end()), 0);
  };
  return (tip(q[1]) - tip(q[0])).norm();
}

TEST(Coverage, FirstOrderIntervalsHoldTheTruthAsOftenAsTheySay) {
  SimulationPlan plan;
  const Simulation simulation = session(plan);
  const testing::ArmNumbers<double> truth(simulation.arm.arm);
  IdentifyOptions options;
  options.noise = Noise{{}, encoder_noise, 1e-4};
  options.leave_out = false;
  int parameters = 0, parameters_held = 0, lengths = 0, lengths_held = 0;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    RandomStream random(9, "coverage", static_cast<std::uint64_t>(repetition));
    Recording recording = simulation.recording;
    for (double& q : recording.joints.reshaped()) q += encoder_noise * random.normal();
    Artefact bar = plan.artefacts[0].certified;
    // A certificate of which one length follows from the others is wrong in all of them in proportion.
    bar.distances.resize(1);
    bar.distances[0].u = u_of_length;
    bar.distances[0].value += u_of_length * random.normal();
    const auto constraints = *build_constraints(recording, {bar});
    const auto found = identify(recording, constraints, options);
    ASSERT_TRUE(found) << found.error().text();
    std::vector<Parameter> free;
    for (const int i : found->free) {
      const IdentifiedParameter& parameter = found->parameters[i];
      free.push_back(parameter.parameter);
      ++parameters;
      const double off = parameter.identified - value(simulation.arm.arm, parameter.parameter);
      parameters_held += std::abs(off) < k_95 * parameter.u ? 1 : 0;
    }
    const UncertainArm arm(found->arm, {free, found->covariance, 0.0, 0.0});
    for (int i = 0; i < 30; ++i) {
      const std::array<Eigen::VectorXd, 2> q{random_posture(found->arm, random), random_posture(found->arm, random)};
      const UncertainTip first = arm.tip(q[0]);
      const UncertainTip second = arm.tip(q[1]);
      const double off = (second.in_base - first.in_base).norm() - true_length(truth, q);
      ++lengths;
      lengths_held += std::abs(off) < k_95 * arm.of_length(first, second) ? 1 : 0;
    }
  }
  // What sixty recordings can tell; 1,000 stand in docs/uncertainty.md.
  EXPECT_NEAR(static_cast<double>(parameters_held) / parameters, 0.95, 0.03);
  EXPECT_NEAR(static_cast<double>(lengths_held) / lengths, 0.95, 0.04);
}

/// Of 95 % intervals of points and lengths by arms whose encoders are eccentric, which the model does not have.
struct Fixed {
  int quantities = 0, fixed = 0, enlarged = 0;

  void add(bool is_held) {
    ++quantities;
    fixed += is_held ? 1 : 0;
  }
  [[nodiscard]] double share() const { return static_cast<double>(fixed) / quantities; }
};

// Where the arm's tip is when its encoders read q.
Eigen::Vector3d true_tip(const VirtualArm& arm, Eigen::VectorXd q) {
  for (std::size_t joint = 0; joint < arm.joints.size(); ++joint) {
    double& angle = q[static_cast<Eigen::Index>(joint)];
    angle += encoder_error(arm.joints[joint], angle);
  }
  return tip_at(arm.arm, 0, q);
}

Fixed with_eccentric_encoders(double eccentricity, int recordings) {
  Fixed all;
  for (int i = 0; i < recordings; ++i) {
    SimulationPlan plan;
    session(plan);
    plan.errors.eccentricity = eccentricity;
    plan.seed = static_cast<std::uint64_t>(100 + i);
    for (VirtualJoint& joint : plan.arm.joints) joint.encoder_noise = encoder_noise;
    const auto simulation = simulate(plan);
    if (!simulation) throw std::runtime_error(simulation.error().text());
    const auto found =
        identify(simulation->recording, *build_constraints(simulation->recording, {plan.artefacts[0].certified}), {});
    if (!found) throw std::runtime_error(found.error().text());
    all.enlarged += found->cross_validation.scale > 1.0 ? 1 : 0;
    std::vector<Parameter> free;
    for (const int p : found->free) free.push_back(found->parameters[p].parameter);
    const UncertainArm arm(found->arm, {free, found->covariance, 0.0, 0.0});
    RandomStream random(9, "eccentric", static_cast<std::uint64_t>(i));
    for (int k = 0; k < 30; ++k) {
      const std::array<Eigen::VectorXd, 2> q{random_posture(found->arm, random), random_posture(found->arm, random)};
      const UncertainTip first = arm.tip(q[0]), second = arm.tip(q[1]);
      const Eigen::Vector3d at = true_tip(simulation->arm, q[0]), other = true_tip(simulation->arm, q[1]);
      const Eigen::Matrix3d covariance = arm.of_point(first);
      for (int axis = 0; axis < 3; ++axis) {
        all.add(std::abs(first.in_base[axis] - at[axis]) < k_95 * std::sqrt(covariance(axis, axis)));
      }
      const double length = (second.in_base - first.in_base).norm();
      all.add(std::abs(length - (other - at).norm()) < k_95 * arm.of_length(first, second));
    }
  }
  return all;
}

// Ten arc seconds in each quadrature part of every encoder: without the placements left out, 95 % intervals hold a
// third.
TEST(Coverage, IntervalsHoldTheTruthWhereTheModelIsWrong) {
  const Fixed wrong = with_eccentric_encoders(10.0 * units::arcsecond, 12);
  EXPECT_GT(wrong.share(), 0.93);
  EXPECT_GE(wrong.enlarged, 11);
}

TEST(Coverage, PlacementsLeftOutChangeNothingWhereTheModelIsRight) {
  const Fixed right = with_eccentric_encoders(0.0, 12);
  // At about 1 % each: two or more of twelve in 2 % of cases at most.
  EXPECT_LE(right.enlarged, 1);
  EXPECT_NEAR(right.share(), 0.95, 0.04);
}

}  // namespace
}  // namespace artcal
