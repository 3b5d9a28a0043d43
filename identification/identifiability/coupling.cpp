#include "identification/identifiability/coupling.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contains.h"
#include "identification/identifiability/common_scale.h"
#include "identification/identifiability/svd.h"
#include "identification/initial/constraint_projection.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/linearisation.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

// No arm reaches less or more, mm; one in metres that says millimetres does.
constexpr double shortest_arm = 10.0;
constexpr double longest_arm = 1e5;

// Where no singular value is larger, mm per mm, readings determine nothing and singular values are rounding: those of
// an arm that was in one posture at each point, say.
constexpr double min_sigma_max = 1.0;

std::vector<int> indices_of(const std::vector<Parameter>& parameters, const std::vector<std::string>& names) {
  std::vector<int> indices;
  for (const auto& name : names) {
    if (const int index = find_parameter(parameters, name); index >= 0) {
      indices.push_back(index);
    }
  }
  return indices;
}

// To mm and rad, the leading coefficient 1, what takes no part exactly 0.
ParameterMotion in_real_units(const ParameterMotion& motion, const Eigen::VectorXd& scale) {
  Eigen::VectorXd clean = motion.coefficients;
  const double largest = clean.cwiseAbs().maxCoeff();
  for (double& value : clean) {
    value = std::abs(value) < no_part * largest ? 0.0 : value;
  }
  clean = clean.cwiseProduct(scale);
  clean /= clean[motion.leading];
  return {clean, motion.leading};
}

// By how much a parameter of an arm is usually off, in physical units: lengths by as much as angles a tenth of the
// reach away move the tip.
Eigen::VectorXd usual_errors(const Arm& arm, const std::vector<Parameter>& parameters, const Eigen::VectorXd& scale) {
  Eigen::VectorXd errors = Eigen::VectorXd::Ones(scale.size());
  const double length = reach(arm);
  for (Eigen::Index i = 0; i < errors.size(); ++i) {
    if (parameters[i].is_angle()) {
      errors[i] = 1.0 / (scale[i] * 0.1 * length);
    }
  }
  return errors;
}

void find_weak(const Eigen::MatrixXd& v, const Eigen::VectorXd& scale, const Eigen::VectorXd& expansion_factor,
               const FixedParameters& fixed, double weak_below, Coupling& coupling) {
  for (Eigen::Index i = coupling.rank - 1; i >= 0; --i) {
    const double singular_value = coupling.singular_values[i];
    if (singular_value >= weak_below * coupling.singular_values[0]) {
      break;
    }
    // What is fixed takes no part: the same direction, in terms of the free parameters.
    const Eigen::VectorXd at_fixed = v.col(i)(fixed.indices);
    const Eigen::VectorXd direction = v.col(i) - fixed.motions * at_fixed;
    Eigen::Index leading = 0;
    direction.cwiseAbs().maxCoeff(&leading);
    const double share =
        expansion_factor.norm() > 0.0 ? std::abs(v.col(i).dot(expansion_factor)) / expansion_factor.norm() : 0.0;
    coupling.weak.push_back({singular_value, in_real_units({direction, static_cast<int>(leading)}, scale), share});
  }
}

}  // namespace

std::vector<int> Coupling::fixed() const {
  std::vector<int> indices;
  for (const auto& motion : unidentifiable) {
    indices.push_back(motion.leading);
  }
  return indices;
}

std::vector<std::string> default_hold_order(const Arm& arm) {
  const auto n = arm.joints.size();
  if (arm.convention == Convention::Modified) {
    return {fmt::format("d{}", n), fmt::format("theta{}", n), "alpha0", "a0", "d1", "theta1"};
  }
  return {fmt::format("a{}", n),     fmt::format("d{}", n),    "d1", "theta1",
          fmt::format("alpha{}", n), fmt::format("theta{}", n)};
}

Expected<Coupling> analyse_coupling(const Recording& recording, const Constraints& constraints, const Arm& arm,
                                    const CouplingOptions& options) {
  if (constraints.features.empty()) {
    return no_solution("there are no readings on any feature, and so nothing to identify an arm from");
  }
  if (const double length = reach(arm); !(length > shortest_arm && length < longest_arm)) {
    return bad_input(
        fmt::format("the arm \"{}\" would reach {:.3g} mm, expected {} mm to {} mm; is a unit of its file "
                    "wrong?",
                    arm.name, length, shortest_arm, longest_arm));
  }
  Coupling coupling;
  for (const auto& parameter : all_parameters(arm)) {
    const bool is_known = parameter.kind == ParameterKind::Radius || parameter.is_joint_error();
    const bool asked = !is_known || contains(options.beside_asked, parameter.name);
    if (asked && !contains(options.not_asked, parameter.name)) {
      coupling.parameters.push_back(parameter);
    }
  }
  coupling.angle_scale = options.angle_scale > 0.0 ? options.angle_scale : reach(arm);
  System system = make_system(recording, constraints, arm, coupling.parameters, coupling.angle_scale);
  auto unknowns = estimate_nuisance_parameters(system, arm, recording);
  if (!unknowns) {
    return tl::unexpected(unknowns.error());
  }
  satisfy_distances(constraints, *unknowns);
  coupling.readings_not_moved = project_onto_constraints(system, recording, arm, *unknowns);
  coupling.residual_count = constraints.residual_count();
  coupling.unknown_count = constraints.unknown_count();

  // Weights are inverse standard deviations; times the noise, singular values are in mm per mm.
  const Weights weights = first_weights(system, arm, *unknowns, options.noise);
  const Linearisation linearisation = linearise(system, weights, Loss::None, arm, *unknowns);
  const Eigen::MatrixXd triangle = typical_noise(weights) * arm_triangle(linearisation, system.arm_size());
  const Svd decomposition = svd(triangle);
  coupling.singular_values = decomposition.values;
  const double sigma_max = std::max(min_sigma_max, coupling.singular_values[0]);
  coupling.rank = static_cast<int>((coupling.singular_values.array() > options.rank_tolerance * sigma_max).count());

  std::vector<std::string> order = options.preferred_fixed;
  for (const auto& name : default_hold_order(arm)) {
    if (!contains(options.rather_free, name)) {
      order.push_back(name);
    }
  }
  const Eigen::MatrixXd& v = decomposition.right_vectors;
  const Eigen::MatrixXd null_space = v.rightCols(v.cols() - coupling.rank);
  const Eigen::VectorXd expansion_factor = scale_motion(arm, coupling.parameters, system.scale);
  const Eigen::VectorXd unidentifiable_scale_motion =
      unidentifiable_scale(arm, coupling.parameters, expansion_factor, null_space);
  const SimplestDirections directions = simplest_directions(
      null_space, usual_errors(arm, coupling.parameters, system.scale),
      {indices_of(coupling.parameters, order), indices_of(coupling.parameters, options.rather_free)},
      unidentifiable_scale_motion);
  for (Eigen::Index i = 0; i < directions.shown.cols(); ++i) {
    const int fixed = directions.fixed.indices[static_cast<std::size_t>(i)];
    coupling.unidentifiable.push_back(in_real_units({directions.shown.col(i), fixed}, system.scale));
  }
  // The part of the common scale that is identifiable.
  const Eigen::VectorXd seen = expansion_factor - null_space * (null_space.transpose() * expansion_factor);
  find_weak(v, system.scale, seen, directions.fixed, options.weak_below, coupling);
  if (unidentifiable_scale_motion.size() > 0) {
    coupling.scale = ScaleState::Unidentifiable;
  } else if (std::any_of(coupling.weak.begin(), coupling.weak.end(),
                         [](const WeakDirection& weak) { return weak.share_of_scale > 0.7; })) {
    coupling.scale = ScaleState::Weak;
  }
  return coupling;
}

}  // namespace artcal
