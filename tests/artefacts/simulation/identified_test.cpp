// What identification makes of simulated recordings: the truth, within what it says of itself; and where the
// arm is no rigid chain, residuals that show it.
#include <cmath>

#include <gtest/gtest.h>

#include "artefacts/constraints/constraint.h"
#include "artefacts/simulation/simulate.h"
#include "core/statistics.h"
#include "identification/identify.h"
#include "tests/support/plans.h"

namespace artcal {
namespace {

SimulationPlan seven_placements() {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 20);
  plan.nominal.probes[0].on_axis = true;
  plan.nominal.probes[0].tip_in_last = {0.0, 0.0, 183.5};
  plan.arm.arm = plan.nominal;
  PlannedPlacement placement;
  plan.placements.clear();
  for (int i = 0; i < 7; ++i) {
    placement.name = std::to_string(i);
    plan.placements.push_back(placement);
  }
  plan.probings[0].placements = {0, 1, 2, 3, 4, 5, 6};
  plan.errors = {0.3, 2e-3, 0.0, 0.0, {"a6", "d6", "d1", "theta1"}};
  for (VirtualJoint& joint : plan.arm.joints) joint.encoder_noise = 2.0 * units::arcsecond;
  plan.noise.probing = 0.003;
  return plan;
}

struct Both {
  Simulation simulation;
  Identification identification;
};

Both identified(const SimulationPlan& plan, const Model& model = {}) {
  auto simulation = simulate(plan, 2);
  if (!simulation) throw std::runtime_error(simulation.error().text());
  std::vector<Artefact> artefacts;
  for (const PlannedArtefact& artefact : plan.artefacts) artefacts.push_back(artefact.certified);
  const auto constraints = build_constraints(simulation->recording, artefacts);
  if (!constraints) throw std::runtime_error(constraints.error().text());
  IdentifyOptions options;
  options.noise = Noise{{}, 2.0 * units::arcsecond, 0.003};
  options.leave_out = false;
  options.model = model;
  options.accept_misfit = true;  // what a model lacks is to be seen in the residuals
  auto identification = identify(simulation->recording, *constraints, options);
  if (!identification) throw std::runtime_error(identification.error().text());
  return {std::move(*simulation), std::move(*identification)};
}

TEST(Identified, TheTruthIsWithinTheUncertainty) {
  double sum = 0.0;
  int count = 0;
  SimulationPlan plan = seven_placements();
  for (plan.seed = 1; plan.seed <= 3; ++plan.seed) {
    const Both both = identified(plan);
    EXPECT_LT(both.identification.chi_squared, both.identification.chi_squared_high * 1.05);
    for (const IdentifiedParameter& parameter : both.identification.parameters) {
      if (parameter.state == ParameterState::Identified) {
        const double off = parameter.identified - value(both.simulation.arm.arm, parameter.parameter);
        EXPECT_LT(std::abs(off), 4.5 * parameter.u) << parameter.parameter.name;
        sum += std::pow(off / parameter.u, 2);
        ++count;
      }
    }
  }
  EXPECT_EQ(count, 3 * 21);
  // Parameters go together in pairs, so that fewer than 63 are independent: wide limits.
  EXPECT_GT(sum / count, 0.4);
  EXPECT_LT(sum / count, 2.0);
}

TEST(Identified, WithoutNoiseTheTruthComesBack) {
  SimulationPlan plan = seven_placements();
  for (VirtualJoint& joint : plan.arm.joints) joint.encoder_noise = 0.0;
  plan.noise.probing = 0.0;
  const Both both = identified(plan);
  EXPECT_LT(both.identification.after.overall.rms, 1e-6);
  for (const IdentifiedParameter& parameter : both.identification.parameters) {
    EXPECT_NEAR(parameter.identified, value(both.simulation.arm.arm, parameter.parameter), 1e-5)
        << parameter.parameter.name;
  }
}

TEST(Identified, EccentricityAndGravityLeaveMoreThanTheNoise) {
  SimulationPlan plan = seven_placements();
  const double noise = identified(plan).identification.after.overall.rms;
  plan.errors.eccentricity = 10.0 * units::arcsecond;
  const Both eccentric = identified(plan);
  EXPECT_GT(eccentric.identification.after.overall.rms, 1.5 * noise);
  EXPECT_GT(eccentric.identification.chi_squared, 2.0 * eccentric.identification.chi_squared_high);
  plan.errors.eccentricity = 0.0;
  for (VirtualJoint& joint : plan.arm.joints) {
    joint.mass = 1.0;
    joint.compliance = 10.0 * units::arcsecond / 1e3;
  }
  const Both bent = identified(plan);
  EXPECT_GT(bent.identification.after.overall.rms, 1.5 * noise);
}

// The virtual arm's amplitudes, phases and compliances are the model's: found by it, they are no longer errors.
TEST(Identified, TheVirtualArmsOwnErrorsComeBack) {
  SimulationPlan plan = seven_placements();
  plan.errors.eccentricity = 10.0 * units::arcsecond;
  plan.errors.second_harmonic = 5.0 * units::arcsecond;
  for (std::size_t i = 0; i < plan.arm.joints.size(); ++i) {
    plan.arm.joints[i].mass = 1.0 + 0.2 * static_cast<double>(i);
    plan.arm.joints[i].compliance = 10.0 * units::arcsecond / 1e3;
    plan.nominal.joints[i].mass = plan.arm.joints[i].mass;
  }
  const Both both =
      identified(plan, {ParameterGroup::Eccentricity, ParameterGroup::SecondEccentricity, ParameterGroup::Gravity});
  EXPECT_LT(both.identification.chi_squared, 1.05 * both.identification.chi_squared_high);
  int seen = 0;
  for (const IdentifiedParameter& p : both.identification.parameters) {
    if (p.state != ParameterState::Identified || !p.parameter.is_joint_error()) continue;
    const VirtualJoint& joint = both.simulation.arm.joints[static_cast<std::size_t>(p.parameter.owner)];
    const bool second = p.parameter.kind == ParameterKind::Cosine2 || p.parameter.kind == ParameterKind::Sine2;
    const bool sine = p.parameter.kind == ParameterKind::Sine1 || p.parameter.kind == ParameterKind::Sine2;
    const Harmonic& harmonic = joint.eccentricity[second ? 1 : 0];
    const double truth = p.parameter.kind == ParameterKind::Compliance ? joint.compliance
                         : sine                                        ? harmonic.amplitude * std::cos(harmonic.phase)
                                                                       : harmonic.amplitude * std::sin(harmonic.phase);
    EXPECT_LT(std::abs(p.identified - truth), 4.5 * p.u) << p.parameter.name;
    ++seen;
  }
  EXPECT_EQ(seen, 24 + 5);
}

// Spreads of the plan come back as parameters of the model.
void expect_truth_of(const Model& model, const Both& both, int parameters) {
  EXPECT_LT(both.identification.chi_squared, 1.05 * both.identification.chi_squared_high);
  EXPECT_GT(both.identification.chi_squared, 0.95 * both.identification.chi_squared_low);
  int seen = 0;
  double sum = 0.0;
  for (const IdentifiedParameter& p : both.identification.parameters) {
    if (p.state != ParameterState::Identified) continue;
    const double off = (p.identified - value(both.simulation.arm.arm, p.parameter)) / p.u;
    EXPECT_LT(std::abs(off), 4.5) << p.parameter.name;
    const bool is_drawn = p.parameter.is_joint_error() || p.parameter.kind == ParameterKind::Radius;
    seen += is_drawn ? 1 : 0;
    sum += is_drawn ? off * off : 0.0;
  }
  EXPECT_EQ(seen, parameters) << model_text(model);
  EXPECT_LT(sum, chi_squared_quantile(1.0 - 1e-4, parameters));
}

TEST(Identified, DrawnGainsCouplingsAndExpansionsComeBack) {
  SimulationPlan plan = seven_placements();
  plan.errors.gain = 2e-4;
  plan.errors.coupling = 1e-4;
  plan.errors.expansion = 12e-6;
  for (std::size_t i = 0; i < plan.placements.size(); ++i) {
    plan.placements[i].arm_temperature = i % 2 == 0 ? 14.0 : 28.0;
    plan.placements[i].arm_temperature_end = i % 2 == 0 ? 27.0 : 15.0;
  }
  const Model model{ParameterGroup::Gain, ParameterGroup::Coupling, ParameterGroup::Thermal};
  expect_truth_of(model, identified(plan, model), 6 + 5 + 6);
}

TEST(Identified, DrawnCompliancesComeBack) {
  SimulationPlan plan = seven_placements();
  for (std::size_t i = 0; i < plan.arm.joints.size(); ++i) {
    plan.nominal.joints[i].mass = plan.arm.arm.joints[i].mass = 1.0 + 0.2 * static_cast<double>(i);
  }
  plan.errors.compliance = 10.0 * units::arcsecond / 1e3;
  expect_truth_of({ParameterGroup::Gravity}, identified(plan, {ParameterGroup::Gravity}), 5);
}

TEST(Identified, TheTipsRadiusComesBack) {
  SimulationPlan plan = seven_placements();
  plan.errors.radius = 0.05;
  for (plan.seed = 1; plan.seed <= 4; ++plan.seed) {
    const Both both = identified(plan, {ParameterGroup::Radius});
    expect_truth_of({ParameterGroup::Radius}, both, 1);
    // Held at 3 mm, what it is off by goes into other parameters or remains.
    const double off = both.simulation.arm.arm.probes[0].radius - 3.0;
    EXPECT_GT(std::abs(off), 1e-3) << plan.seed;
  }
}

}  // namespace
}  // namespace artcal
