#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "acquisition/arm/arm.h"

namespace artcal {

/// What one parameter of an arm is: of its chain (A to TipZ), of its tips, or of its JointErrors (from Cosine1).
enum class ParameterKind {
  A,
  D,
  Theta,
  Alpha,
  Beta,
  TipX,
  TipY,
  TipZ,
  Radius,
  Cosine1,
  Sine1,
  Cosine2,
  Sine2,
  Gain,
  Coupling,
  Compliance,
  Expansion
};
inline constexpr int joint_error_kinds = 8;

/// One parameter. `owner` is the joint's index, or the probe's for a tip coordinate or radius.
struct Parameter {
  /// As the field writes it: a6, theta6, l, lx, with several probes l:star; of joint errors, by the joint's number,
  /// what they multiply or are: cos_q3, sin_2q3, gain3, coupling3, compliance3, expansion3.
  std::string name;
  ParameterKind kind = ParameterKind::A;
  int owner = 0;

  [[nodiscard]] bool is_angle() const;
  [[nodiscard]] bool is_length() const;
  [[nodiscard]] bool is_tip() const {
    return kind == ParameterKind::TipX || kind == ParameterKind::TipY || kind == ParameterKind::TipZ;
  }
  [[nodiscard]] bool is_joint_error() const { return kind >= ParameterKind::Cosine1; }
  [[nodiscard]] std::string_view unit() const;  ///< mm, rad, rad/rad, rad/(N mm), 1/K
};

/// All structural parameters of an arm, in the order used for vectors and matrices everywhere:
/// a, d, theta, alpha, each joint after joint; Hayati angles where a joint has one; then the tips.
/// In modified DH a and alpha carry the index of the link before: a0 … a(n-1), d1 … dn.
std::vector<Parameter> parameters_of(const Arm& arm);

/// The same and the radii of the tips: radius, with several probes radius:star. A radius does not move the
/// tip's centre, and its maker knows it; it is a parameter only where it is asked for.
std::vector<Parameter> parameters_with_radii(const Arm& arm);

/// The same and all joint errors, kind after kind: everything of an arm that can be a parameter. Joint errors are
/// parameters only where a model has them (identification/models/model.h). The first joint has no coupling.
std::vector<Parameter> all_parameters(const Arm& arm);

double value(const Arm& arm, const Parameter& parameter);
void set_value(Arm& arm, const Parameter& parameter, double value);

/// How far the parameter must move to move the tip by about 1 mm: 1 mm for a length, 1/reach rad for an
/// angle or what multiplies one; for a compliance 1/reach rad at 1000 N·mm, for an expansion 1/reach at 10 K. Ranks and
/// condition numbers are taken in these units, never in column norms, which would turn the rounding error of a
/// vanishing column into a direction.
double physical_scale(const Parameter& parameter, double reach);

/// Index in `parameters` by name, or -1.
int find_parameter(const std::vector<Parameter>& parameters, std::string_view name);

}  // namespace artcal
