#pragma once

#include <string>

#include "core/units.h"
#include "identification/models/model.h"
#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

/// Arms with joint errors, and what they read on a bar: sessions of simulated_session.h.
namespace artcal::testing {

inline constexpr double newton_metre = 1e3;  // N·mm

inline Arm nominal_arm() {
  Arm arm = test::gao_arm();
  arm.probes.front().radius = 3.0;
  for (Joint& joint : arm.joints) joint.mass = 1.5;
  return arm;
}

/// Errors of a group, as large as a maker would want to know of.
inline void plant(ParameterGroup group, Arm& arm, RandomStream& random) {
  for (const Parameter& parameter : members_of(group, arm)) {
    const double size = parameter.is_length()                         ? 0.05
                        : parameter.kind == ParameterKind::Beta       ? 1e-3
                        : parameter.is_angle()                        ? 15.0 * units::arcsecond
                        : parameter.kind == ParameterKind::Compliance ? 8.0 * units::arcsecond / newton_metre
                        : parameter.kind == ParameterKind::Expansion  ? 15e-6
                                                                      : 1e-4;
    const bool is_positive = parameter.kind == ParameterKind::Compliance || parameter.kind == ParameterKind::Expansion;
    const double deviate = is_positive ? random.uniform(0.5, 1.5) : random.normal();
    set_value(arm, parameter, value(arm, parameter) + size * deviate);
  }
}

inline Arm true_arm(const Arm& nominal, const Model& model, std::uint64_t seed) {
  RandomStream random(seed, "true arm");
  Arm truth = arm_with_errors(arm_for(model, nominal), random, 0.2, 1e-3);
  for (const ParameterGroup group : model) plant(group, truth, random);
  return truth;
}

/// A bar with three seats, certified, in eight placements, in a hall that warms up while each is read.
inline test::Bound bar_session(const Arm& nominal, const Arm& truth, std::uint64_t seed, SessionNoise noise = {},
                               int placements = 8, double warming = 8.0) {
  Artefact bar;
  bar.name = "bar";
  const double places[] = {0.0, 300.0, 750.0};
  for (const char* name : {"A", "B", "C"}) bar.features.push_back(feature_of(name, FeatureKind::Point));
  bar.distances = {{0, 1, 300.0, 4e-4}, {0, 2, 750.0, 4e-4}, {1, 2, 450.0, 4e-4}};
  Session session(nominal, truth, seed, noise);
  for (int p = 0; p < placements; ++p) {
    const Rigid pose = session.pose();
    for (int visit = 0; visit < 2; ++visit) {
      session.set_arm_temperature(22.0 + warming * (visit == 0 ? -1.0 : 1.0) + 0.5 * p);
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d at = pose * Eigen::Vector3d(places[i], 0.0, 0.0);
        for (std::size_t probe = 0; probe < truth.probes.size(); ++probe) {
          session.read(
              "bar", std::to_string(p), bar.features[i].name, 8, [&](int) { return at; }, static_cast<int>(probe));
        }
      }
    }
  }
  return test::bind(session.recording(), {bar});
}

/// A bar with three balls, diameters and distances certified, in six placements.
inline test::Bound ball_session(const Arm& nominal, const Arm& truth, std::uint64_t seed, SessionNoise noise = {}) {
  Artefact bar;
  bar.name = "bar";
  const double places[] = {0.0, 300.0, 750.0};
  for (const char* name : {"A", "B", "C"}) {
    bar.features.push_back(feature_of(name, FeatureKind::Sphere));
    bar.features.back().radius = 12.7;
  }
  bar.distances = {{0, 1, 300.0, 4e-4}, {0, 2, 750.0, 4e-4}, {1, 2, 450.0, 4e-4}};
  Session session(nominal, truth, seed, noise);
  for (int p = 0; p < 6; ++p) {
    const Rigid pose = session.pose();
    const Eigen::Vector3d stand = session.random().direction();
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d at = pose * Eigen::Vector3d(places[i], 0.0, 0.0);
      session.read_ball("bar", std::to_string(p), bar.features[i].name, 20, at, 12.7, stand);
    }
  }
  return test::bind(session.recording(), {bar});
}

inline IdentifyOptions options_for(const Model& model) {
  IdentifyOptions options;
  const SessionNoise noise;
  options.noise = Noise{{}, noise.encoder, noise.probing};
  options.leave_out = false;
  options.model = model;
  return options;
}

}  // namespace artcal::testing
