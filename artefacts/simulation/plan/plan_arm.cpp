#include "artefacts/simulation/plan/plan_arm.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "acquisition/arm/joint_error_keys.h"
#include "acquisition/arm/parameters.h"
#include "artefacts/simulation/plan/plan_keys.h"
#include "core/plausible.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double newton_metre = 1e3;        // N·mm
constexpr double max_of_radius = 0.1;       // a spread of it beyond which a tip may vanish
constexpr double max_encoder_error = 0.01;  // rad; what is more is a broken encoder, not an eccentric one

Harmonic read_first_harmonic(TomlTable& table, double angle) {
  Harmonic harmonic;
  const bool by_grating = table.has("eccentricity");
  if (by_grating) {
    const double eccentricity = length_at(table, "eccentricity");
    const double grating = length_at(table, "grating");
    if (grating <= 0.0) {
      table.fail("grating",
                 "`eccentricity` needs the diameter of the grating, such as grating = \"60 mm\"; the encoder's error "
                 "comes from both");
    } else {
      harmonic.amplitude = eccentricity_amplitude(eccentricity, grating);
    }
  }
  if (table.has("first_harmonic")) {
    harmonic.amplitude = angle_at(table, "first_harmonic");
    if (by_grating) {
      table.fail("first_harmonic", "state either `eccentricity` with `grating`, or `first_harmonic`, not both");
    }
  }
  harmonic.phase = table.number_or("first_phase", 0.0) * angle;
  return harmonic;
}

void read_stops(TomlTable& table, VirtualJoint& joint, double angle) {
  const auto stops = pair_at(table, "stops");
  if (!stops) {
    return;
  }
  // `angle` is the unit of what the joint reads.
  joint.low = angle * stops->x();
  joint.high = angle * stops->y();
  if (!(joint.low < joint.high) || joint.high - joint.low > 7200.0 * units::degree) {
    table.fail("stops", fmt::format("the end stops are {} and {}, expected the lower before the higher, and at most 20 "
                                    "turns between them",
                                    stops->x(), stops->y()));
  }
}

VirtualJoint read_virtual_joint(TomlTable table, VirtualJoint joint, double angle, bool slides) {
  if (slides) {
    joint.encoder_noise = length_at(table, "encoder");
    read_stops(table, joint, 1.0);
    return joint;
  }
  joint.encoder_noise = angle_at(table, "encoder", joint.encoder_noise);
  joint.eccentricity[0] = read_first_harmonic(table, angle);
  joint.eccentricity[1] = {angle_at(table, "second_harmonic"), table.number_or("second_phase", 0.0) * angle};
  for (const Harmonic& harmonic : joint.eccentricity) {
    if (harmonic.amplitude > max_encoder_error) {
      table.fail("", fmt::format("an encoder error of {:.0f} arcsec is beyond what can be simulated, expected at most "
                                 "{:.0f} arcsec",
                                 harmonic.amplitude / units::arcsecond, max_encoder_error / units::arcsecond));
    }
  }
  joint.compliance = number_between(table, "compliance_arcsec_per_Nm", 0.0, 0.0, 1e4) * units::arcsecond / newton_metre;
  joint.mass = number_between(table, "mass_kg", 0.0, 0.0, 1e3);
  read_stops(table, joint, angle);
  return joint;
}

// A tenth of the most that an arm's file may state.
double spread_at(TomlTable& table, const char* key, ParameterKind kind, double unit) {
  return unit * number_between(table, key, 0.0, 0.0, std::round(0.1 * most_of(kind) / unit));
}

void read_joint_error_sizes(TomlTable& table, const Arm& arm, ArmErrors& errors) {
  constexpr double ppm = 1e-6;
  errors.gain = spread_at(table, "gain_ppm", ParameterKind::Gain, ppm);
  errors.coupling = spread_at(table, "coupling_ppm", ParameterKind::Coupling, ppm);
  errors.compliance =
      spread_at(table, "compliance_arcsec_per_Nm", ParameterKind::Compliance, units::arcsecond / newton_metre);
  errors.expansion = spread_at(table, "expansion_ppm_per_K", ParameterKind::Expansion, ppm);
  if (errors.compliance > 0.0 && !has_masses(arm)) {
    table.fail("compliance_arcsec_per_Nm",
               fmt::format("not every joint of the arm {} states the mass of its link (`mass_kg` in the arm's file), "
                           "without which no joint bends",
                           in_quotes(arm.name)));
  }
  errors.radius = length_at(table, "radius");
  for (const Probe& probe : arm.probes) {
    if (errors.radius > max_of_radius * probe.radius) {
      table.fail("radius",
                 fmt::format("radii are to be drawn with {:g} mm, but that of the tip {} is {:g} mm, expected "
                             "a tenth of it at most",
                             errors.radius, in_quotes(probe.name), probe.radius));
    }
  }
}

bool is_harmonic(ParameterKind kind) { return kind >= ParameterKind::Cosine1 && kind <= ParameterKind::Sine2; }

}  // namespace

VirtualJoint plain_joint(const Joint& real, double encoder_noise) {
  constexpr double turn = 2.0 * std::numbers::pi;
  VirtualJoint joint;
  if (real.is_prismatic()) {
    joint.low = real.lowest.value_or(0.0);
    joint.high = real.highest.value_or(joint.low);
    return joint;
  }
  joint.encoder_noise = encoder_noise;
  if (real.lowest || real.highest) {
    joint.low = real.lowest ? *real.lowest : *real.highest - turn;
    joint.high = real.highest ? *real.highest : *real.lowest + turn;
  }
  return joint;
}

ArmErrors read_arm_errors(TomlTable table, const Arm& arm) {
  ArmErrors errors;
  read_joint_error_sizes(table, arm, errors);
  errors.length = length_at(table, "length");
  errors.angle = angle_at(table, "angle");
  errors.eccentricity = angle_at(table, "first_harmonic");
  errors.second_harmonic = angle_at(table, "second_harmonic");
  errors.exact = table.texts("exact");
  const auto parameters = all_parameters(arm);
  for (const auto& name : errors.exact) {
    const int found = find_parameter(parameters, name);
    if (found < 0 || is_harmonic(parameters[found].kind)) {
      table.fail("exact", fmt::format("{} is not a parameter of the arm {}", in_quotes(name), in_quotes(arm.name)));
    }
  }
  if (errors.eccentricity > 0.1 * max_encoder_error || errors.second_harmonic > 0.1 * max_encoder_error) {
    table.fail("", fmt::format("harmonics are to be drawn with more than {:.0f} arcsec, which cannot be simulated",
                               0.1 * max_encoder_error / units::arcsecond));
  }
  return errors;
}

namespace {

// Zero is a noise that a simulation may have, but none far below or above what an arm has.
double noise_length_at(TomlTable& table, std::string_view key) {
  const double noise = length_at(table, key);
  if (noise > 0.0 && !plausible::is_length_u(noise)) {
    table.fail(key, fmt::format("the noise `{}` is {:.6g} mm, expected 0 or {}; is the unit right?", key, noise,
                                plausible::length_range));
  }
  return noise;
}

}  // namespace

PlannedNoise read_planned_noise(TomlTable& table) {
  PlannedNoise noise;
  noise.probing = noise_length_at(table, "probing");
  if (const double encoder = angle_at(table, "encoder"); encoder > 0.0 && !plausible::is_angle_u(encoder)) {
    table.fail("encoder", fmt::format("the noise `encoder` is {:.6g} rad, expected 0 or {}; is the unit right?",
                                      encoder, plausible::angle_range));
  }
  noise.temperature = number_between(table, "temperature_K", 0.0, 0.0, 100.0);
  if (table.has("instrument")) {
    noise.instrument = noise_length_at(table, "instrument");
  }
  return noise;
}

void read_virtual_joints(TomlTable& root, VirtualArm& arm, double angle, double encoder_noise) {
  auto tables = root.tables("joint");
  if (!tables.empty() && tables.size() != arm.arm.joints.size()) {
    root.fail("joint", fmt::format("there are {} tables headed [[joint]], but the arm {} has {} joints, expected one "
                                   "each or none",
                                   tables.size(), in_quotes(arm.arm.name), arm.arm.joints.size()));
    return;
  }
  arm.joints.clear();
  for (std::size_t i = 0; i < arm.arm.joints.size(); ++i) {
    const VirtualJoint plain = plain_joint(arm.arm.joints[i], encoder_noise);
    const bool slides = arm.arm.joints[i].is_prismatic();
    arm.joints.push_back(tables.empty() ? plain : read_virtual_joint(std::move(tables[i]), plain, angle, slides));
    if (slides && !(arm.joints.back().low < arm.joints.back().high)) {
      root.fail("joint", fmt::format("joint {} is prismatic, and the ends of its travel are not known; state `min` and "
                                     "`max` in the arm's file, or `stops` in its [[joint]] of the plan (in mm)",
                                     i + 1));
    }
  }
}

void check_same_kind(TomlTable& root, const Arm& nominal, const Arm& real) {
  bool same = nominal.convention == real.convention && nominal.joints.size() == real.joints.size() &&
              nominal.probes.size() == real.probes.size();
  for (std::size_t i = 0; same && i < nominal.joints.size(); ++i) {
    same = nominal.joints[i].sign == real.joints[i].sign && nominal.joints[i].type == real.joints[i].type &&
           nominal.joints[i].mechanical_coupling == real.joints[i].mechanical_coupling;
  }
  for (std::size_t i = 0; same && i < nominal.probes.size(); ++i) {
    same = nominal.probes[i].name == real.probes[i].name;
  }
  if (!same) {
    root.fail("true_arm",
              "the true arm and the nominal one differ in more than their numbers, expected the same "
              "convention, number, types, signs and mechanical couplings of joints, and probes");
  }
}

}  // namespace artcal
