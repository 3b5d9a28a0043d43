#include "artefacts/simulation/true_arm.h"

#include <algorithm>
#include <cmath>

#include "acquisition/arm/parameters.h"
#include "core/random.h"

namespace artcal {
namespace {

void add_drawn(Harmonic& harmonic, double size, RandomStream& random) {
  const double sine = harmonic.amplitude * std::cos(harmonic.phase) + size * random.normal();
  const double cosine = harmonic.amplitude * std::sin(harmonic.phase) + size * random.normal();
  if (size > 0.0) {
    harmonic = {std::hypot(sine, cosine), std::atan2(cosine, sine)};
  }
}

double size_of(const ArmErrors& errors, ParameterKind kind) {
  switch (kind) {
    case ParameterKind::Radius: return errors.radius;
    case ParameterKind::Gain: return errors.gain;
    case ParameterKind::Coupling: return errors.coupling;
    case ParameterKind::Compliance: return errors.compliance;
    case ParameterKind::Expansion: return errors.expansion;
    default: return 0.0;  // drawn with the chain or with the encoders
  }
}

void draw_beside_the_chain(const ArmErrors& errors, std::uint64_t seed, Arm& arm) {
  for (const Parameter& parameter : all_parameters(arm)) {
    const double size = size_of(errors, parameter.kind);
    if (size > 0.0 && std::find(errors.exact.begin(), errors.exact.end(), parameter.name) == errors.exact.end()) {
      const double drawn =
          value(arm, parameter) + size * RandomStream(seed, "arm parameter " + parameter.name).normal();
      // No joint stiffens under a load.
      set_value(arm, parameter, parameter.kind == ParameterKind::Compliance ? std::abs(drawn) : drawn);
    }
  }
}

}  // namespace

VirtualArm drawn_arm(const SimulationPlan& plan) {
  VirtualArm arm = plan.arm;
  const ArmErrors& errors = plan.errors;
  const auto parameters = parameters_of(arm.arm);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    const double deviate = RandomStream(plan.seed, "arm parameter", i).normal();
    if (std::find(errors.exact.begin(), errors.exact.end(), parameter.name) == errors.exact.end()) {
      set_value(arm.arm, parameter,
                value(arm.arm, parameter) + deviate * (parameter.is_angle() ? errors.angle : errors.length));
    }
  }
  draw_beside_the_chain(errors, plan.seed, arm.arm);
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    RandomStream random(plan.seed, "encoder", i);
    add_drawn(arm.joints[i].eccentricity[0], errors.eccentricity, random);
    add_drawn(arm.joints[i].eccentricity[1], errors.second_harmonic, random);
  }
  return arm;
}

}  // namespace artcal
