#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "acquisition/arm.h"

namespace artcal {

/// What one structural parameter of an arm is.
enum class ParameterKind { A, D, Theta, Alpha, Beta, TipX, TipY, TipZ, Radius };

/// One structural parameter. `owner` is the joint's index, or the probe's for a tip coordinate or radius.
struct Parameter {
  std::string name;  ///< as the field writes it: a6, theta6, l, lx; with several probes l:star
  ParameterKind kind = ParameterKind::A;
  int owner = 0;

  [[nodiscard]] bool is_angle() const {
    return kind == ParameterKind::Theta || kind == ParameterKind::Alpha || kind == ParameterKind::Beta;
  }
  [[nodiscard]] bool is_tip() const {
    return kind == ParameterKind::TipX || kind == ParameterKind::TipY || kind == ParameterKind::TipZ;
  }
  [[nodiscard]] std::string_view unit() const { return is_angle() ? "rad" : "mm"; }
};

/// All structural parameters of an arm, in the order used for vectors and matrices everywhere:
/// a, d, theta, alpha, each joint after joint; Hayati angles where a joint has one; then the tips.
/// In modified DH a and alpha carry the index of the link before: a0 … a(n-1), d1 … dn.
std::vector<Parameter> parameters_of(const Arm& arm);

/// The same and the radii of the tips: radius, with several probes radius:star. A radius does not move the
/// tip's centre, and its maker knows it; it is a parameter only where it is asked for.
std::vector<Parameter> parameters_with_radii(const Arm& arm);

double value(const Arm& arm, const Parameter& parameter);
void set_value(Arm& arm, const Parameter& parameter, double value);

/// How far the parameter must move to move the tip by about 1 mm: 1 mm for a length, 1/reach rad for an
/// angle. Ranks and condition numbers are taken in these units, never in column norms, which would turn
/// the rounding error of a vanishing column into a direction.
double physical_scale(const Parameter& parameter, double reach);

/// Index in `parameters` by name, or -1.
int find_parameter(const std::vector<Parameter>& parameters, std::string_view name);

}  // namespace artcal
