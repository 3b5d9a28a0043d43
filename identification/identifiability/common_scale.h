#pragma once

#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/parameters.h"
#include "identification/identifiability/fixed_parameters.h"

namespace artcal {

/// Of a direction in physical units, relative to its largest coefficient: below it a parameter takes no part.
inline constexpr double no_part = 1e-7;

/// The common growth of all lengths in physical units (of `scale`, see System): the motion that readings without a
/// calibrated length cannot see. Torques grow with lengths, so that compliances shrink.
Eigen::VectorXd scale_motion(const Arm& arm, const std::vector<Parameter>& parameters, const Eigen::VectorXd& scale);

/// The common growth as a direction of the null space, in physical units: with a radius of the tip that takes up the
/// growth of balls of one size, where there is one. Empty if the scale is identifiable, or a length is taken as known.
/// `growth` is scale_motion() of `parameters`, `null_space` has orthonormal columns.
Eigen::VectorXd unidentifiable_scale(const Arm& arm, const std::vector<Parameter>& parameters,
                                     const Eigen::VectorXd& expansion_factor, const Eigen::MatrixXd& null_space);

/// The unidentifiable directions in their simplest form, in physical units.
struct SimplestDirections {
  FixedParameters fixed;
  /// As FixedParameters::motions; but the scale, where it is among them, is the last one, and is all lengths in
  /// proportion, save those that are not identifiable by themselves.
  Eigen::MatrixXd shown;
};

/// The same choice as choose_fixed() where `unidentifiable_scale` is empty. Else the scale is set apart first: one of
/// the lengths is fixed for it, the one beside which the other directions have the fewest terms, and these are reduced
/// beside it.
SimplestDirections simplest_directions(const Eigen::MatrixXd& null_space, const Eigen::VectorXd& tolerances,
                                       const FixingOrder& order, const Eigen::VectorXd& unidentifiable_scale);

}  // namespace artcal
