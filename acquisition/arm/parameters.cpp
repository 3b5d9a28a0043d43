#include "acquisition/arm/parameters.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace artcal {
namespace {

void add_joints(std::vector<Parameter>& all, const Arm& arm, ParameterKind kind, std::string_view symbol, int first) {
  for (int i = 0; i < static_cast<int>(arm.joints.size()); ++i) {
    if (kind != ParameterKind::Beta || arm.joints[i].has_beta) {
      all.push_back({fmt::format("{}{}", symbol, i + first), kind, i});
    }
  }
}

std::string suffix_of(const Arm& arm, int probe) { return arm.probes.size() > 1 ? ":" + arm.probes[probe].name : ""; }

void add_tip(std::vector<Parameter>& all, const Arm& arm, int probe) {
  const Probe& tip = arm.probes[probe];
  const std::string suffix = suffix_of(arm, probe);
  if (tip.on_axis) {
    all.push_back({"l" + suffix, ParameterKind::TipZ, probe});
    return;
  }
  all.push_back({"lx" + suffix, ParameterKind::TipX, probe});
  all.push_back({"ly" + suffix, ParameterKind::TipY, probe});
  all.push_back({"lz" + suffix, ParameterKind::TipZ, probe});
}

// One place that says where a parameter lives; const and mutable access share it.
template <typename AnyArm>
auto& slot(AnyArm& arm, const Parameter& parameter) {
  const auto owner = static_cast<std::size_t>(parameter.owner);
  switch (parameter.kind) {
    case ParameterKind::A: return arm.joints[owner].a;
    case ParameterKind::D: return arm.joints[owner].d;
    case ParameterKind::Theta: return arm.joints[owner].theta;
    case ParameterKind::Alpha: return arm.joints[owner].alpha;
    case ParameterKind::Beta: return arm.joints[owner].beta;
    case ParameterKind::TipX: return arm.probes[owner].tip_in_last.x();
    case ParameterKind::TipY: return arm.probes[owner].tip_in_last.y();
    case ParameterKind::Radius: return arm.probes[owner].radius;
    case ParameterKind::Cosine1: return arm.joints[owner].errors.cosine[0];
    case ParameterKind::Sine1: return arm.joints[owner].errors.sine[0];
    case ParameterKind::Cosine2: return arm.joints[owner].errors.cosine[1];
    case ParameterKind::Sine2: return arm.joints[owner].errors.sine[1];
    case ParameterKind::Gain: return arm.joints[owner].errors.gain;
    case ParameterKind::Coupling: return arm.joints[owner].errors.coupling;
    case ParameterKind::Compliance: return arm.joints[owner].errors.compliance;
    case ParameterKind::Expansion: return arm.joints[owner].errors.expansion;
    case ParameterKind::TipZ: break;
  }
  return arm.probes[owner].tip_in_last.z();
}

// Whether the joint may have such an error: a prismatic one has no encoder that turns, and couplings are between
// angles.
bool may_have(const Arm& arm, int joint, ParameterKind error) {
  const auto slides = [&](int i) { return arm.joints[static_cast<std::size_t>(i)].is_prismatic(); };
  if (error == ParameterKind::Coupling) {
    return joint > 0 && !slides(joint) && !slides(joint - 1);
  }
  return !slides(joint) || error == ParameterKind::Gain || error == ParameterKind::Expansion;
}

constexpr double typical_torque = 1e3;               // N·mm
constexpr double typical_temperature_offset = 10.0;  // K
}  // namespace

std::vector<Parameter> parameters_of(const Arm& arm) {
  const int link = arm.convention == Convention::Modified ? 0 : 1;
  std::vector<Parameter> all;
  add_joints(all, arm, ParameterKind::A, "a", link);
  add_joints(all, arm, ParameterKind::D, "d", 1);
  add_joints(all, arm, ParameterKind::Theta, "theta", 1);
  add_joints(all, arm, ParameterKind::Alpha, "alpha", link);
  add_joints(all, arm, ParameterKind::Beta, "beta", link);
  for (int probe = 0; probe < static_cast<int>(arm.probes.size()); ++probe) {
    add_tip(all, arm, probe);
  }
  return all;
}

std::vector<Parameter> parameters_with_radii(const Arm& arm) {
  std::vector<Parameter> all = parameters_of(arm);
  for (int probe = 0; probe < static_cast<int>(arm.probes.size()); ++probe) {
    all.push_back({"radius" + suffix_of(arm, probe), ParameterKind::Radius, probe});
  }
  return all;
}

std::vector<Parameter> all_parameters(const Arm& arm) {
  constexpr std::array<std::string_view, joint_error_kinds> symbols{"cos_q", "sin_q",    "cos_2q",     "sin_2q",
                                                                    "gain",  "coupling", "compliance", "expansion"};
  std::vector<Parameter> all = parameters_with_radii(arm);
  for (int k = 0; k < joint_error_kinds; ++k) {
    const auto kind = static_cast<ParameterKind>(static_cast<int>(ParameterKind::Cosine1) + k);
    for (int joint = 0; joint < static_cast<int>(arm.joints.size()); ++joint) {
      if (may_have(arm, joint, kind)) {
        all.push_back({fmt::format("{}{}", symbols[static_cast<std::size_t>(k)], joint + 1), kind, joint});
      }
    }
  }
  return all;
}

bool Parameter::is_angle() const {
  return kind == ParameterKind::Theta || kind == ParameterKind::Alpha || kind == ParameterKind::Beta ||
         (kind >= ParameterKind::Cosine1 && kind <= ParameterKind::Sine2);
}

bool Parameter::is_length() const {
  return kind == ParameterKind::A || kind == ParameterKind::D || is_tip() || kind == ParameterKind::Radius;
}

std::string_view Parameter::unit() const {
  switch (kind) {
    case ParameterKind::Gain:
    case ParameterKind::Coupling: return "rad/rad";
    case ParameterKind::Compliance: return "rad/(N mm)";
    case ParameterKind::Expansion: return "1/K";
    default: return is_angle() ? "rad" : "mm";
  }
}

double value(const Arm& arm, const Parameter& parameter) { return slot(arm, parameter); }

void set_value(Arm& arm, const Parameter& parameter, double new_value) { slot(arm, parameter) = new_value; }

double physical_scale(const Parameter& parameter, double reach) {
  if (parameter.is_length()) {
    return 1.0;
  }
  const double size = parameter.kind == ParameterKind::Compliance  ? typical_torque
                      : parameter.kind == ParameterKind::Expansion ? typical_temperature_offset
                                                                   : 1.0;
  return 1.0 / (reach * size);
}

int find_parameter(const std::vector<Parameter>& parameters, std::string_view name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  return found == parameters.end() ? -1 : static_cast<int>(found - parameters.begin());
}

}  // namespace artcal
