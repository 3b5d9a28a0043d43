#include "identification/coupling_analysis.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/QR>

#include "identification/consistent.h"
#include "identification/settle.h"
#include "identification/svd.h"
#include "identification/weights.h"

namespace artcal {
namespace {

// No arm reaches less or more, mm; one in metres that says millimetres does.
constexpr double shortest_arm = 10.0;
constexpr double longest_arm = 1e5;

// Below this, relative to the largest coefficient and in physical units, a parameter takes no part.
constexpr double no_part = 1e-7;

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<int> indices_of(const std::vector<Parameter>& parameters, const std::vector<std::string>& names) {
  std::vector<int> indices;
  for (const auto& name : names) {
    if (const int index = find_parameter(parameters, name); index >= 0) {
      indices.push_back(index);
    }
  }
  return indices;
}

// Reduces the null space (parameters × dimensions, orthonormal columns) to one motion a held parameter in
// which no other held parameter takes part: Gauss-Jordan with the pivots in the order of preference.
std::vector<ParameterMotion> reduce(Eigen::MatrixXd null_space, const std::vector<int>& preferred,
                                    const std::vector<int>& last) {
  std::vector<int> pivots;
  const auto try_pivot = [&](int parameter, double least) {
    const auto done = static_cast<Eigen::Index>(pivots.size());
    if (done == null_space.cols() || std::find(pivots.begin(), pivots.end(), parameter) != pivots.end()) {
      return;
    }
    Eigen::Index best = 0;
    const double size = null_space.row(parameter).tail(null_space.cols() - done).cwiseAbs().maxCoeff(&best);
    if (size <= least * null_space.rightCols(null_space.cols() - done).cwiseAbs().maxCoeff()) {
      return;
    }
    null_space.col(done).swap(null_space.col(done + best));
    null_space.col(done) /= null_space(parameter, done);
    for (Eigen::Index other = 0; other < null_space.cols(); ++other) {
      if (other != done) {
        null_space.col(other) -= null_space(parameter, other) * null_space.col(done);
      }
    }
    pivots.push_back(parameter);
  };
  for (const int parameter : preferred) {
    try_pivot(parameter, 1e-6);
  }
  const auto is_last = [&](int p) { return std::find(last.begin(), last.end(), p) != last.end(); };
  for (const double least : {1e-2, 1e-6}) {
    for (int parameter = 0; parameter < null_space.rows(); ++parameter) {
      if (!is_last(parameter)) {
        try_pivot(parameter, least);
      }
    }
  }
  for (const int parameter : last) {
    try_pivot(parameter, 0.0);
  }
  std::vector<ParameterMotion> motions;
  for (std::size_t i = 0; i < pivots.size(); ++i) {
    motions.push_back({null_space.col(static_cast<Eigen::Index>(i)), pivots[i]});
  }
  return motions;
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

// The common growth of all lengths, in physical units: the motion that readings without any calibrated length cannot
// see. Torques grow with lengths, so that compliances shrink.
Eigen::VectorXd scale_motion(const Arm& arm, const std::vector<Parameter>& parameters, const Eigen::VectorXd& scale) {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(scale.size());
  for (Eigen::Index i = 0; i < motion.size(); ++i) {
    const double size = value(arm, parameters[i]) / scale[i];
    motion[i] = parameters[i].is_length() ? size : parameters[i].kind == ParameterKind::Compliance ? -size : 0.0;
  }
  return motion;
}

// The part of the growth that is seen whatever the tips' radii do: with balls of one size an unknown radius of the
// tip takes up the growth of the ball.
Eigen::VectorXd seen_beside_radii(const Eigen::VectorXd& growth, const Eigen::MatrixXd& null_space,
                                  const std::vector<Parameter>& parameters) {
  Eigen::MatrixXd unseen = null_space;
  for (Eigen::Index i = 0; i < growth.size(); ++i) {
    if (parameters[i].kind == ParameterKind::Radius) {
      unseen.conservativeResize(growth.size(), unseen.cols() + 1);
      unseen.rightCols<1>() = Eigen::VectorXd::Unit(growth.size(), i);
    }
  }
  if (unseen.cols() == 0) {
    return growth;
  }
  return growth - unseen * unseen.completeOrthogonalDecomposition().solve(growth);
}

// A length taken as known fixes the scale even if no reading does.
bool scale_is_asked(const Arm& arm, const std::vector<Parameter>& asked) {
  const auto all = parameters_of(arm);
  return std::all_of(all.begin(), all.end(), [&](const Parameter& parameter) {
    return !parameter.is_length() || value(arm, parameter) == 0.0 || find_parameter(asked, parameter.name) >= 0;
  });
}

void find_weak(const Eigen::MatrixXd& v, const Eigen::VectorXd& scale, const Eigen::VectorXd& growth,
               const std::vector<ParameterMotion>& lost_scaled, double weak_below, Coupling& coupling) {
  for (Eigen::Index i = coupling.rank - 1; i >= 0; --i) {
    const double singular_value = coupling.singular_values[i];
    if (singular_value >= weak_below * coupling.singular_values[0]) {
      break;
    }
    // What is held takes no part: the same direction, told in the free parameters.
    Eigen::VectorXd direction = v.col(i);
    for (const auto& lost : lost_scaled) {
      direction -= direction[lost.leading] * lost.coefficients;
    }
    Eigen::Index leading = 0;
    direction.cwiseAbs().maxCoeff(&leading);
    const double share = growth.norm() > 0.0 ? std::abs(v.col(i).dot(growth)) / growth.norm() : 0.0;
    coupling.weak.push_back({singular_value, in_real_units({direction, static_cast<int>(leading)}, scale), share});
  }
}

// Whether the analysis leaves readings and unknowns where they are (make_consistent, satisfy_distances).
bool is_as_read(const Constraints& constraints) {
  return constraints.binding_distance_count() == 0 &&
         std::none_of(constraints.features.begin(), constraints.features.end(),
                      [&](const FeatureConstraint& feature) { return needs_moving(feature, constraints); });
}

}  // namespace

std::vector<int> Coupling::held() const {
  std::vector<int> indices;
  for (const auto& motion : lost) {
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

Expected<CouplingAnalysis> analyse(const Recording& recording, const Constraints& constraints, const Arm& arm,
                                   const CouplingOptions& options) {
  if (constraints.features.empty()) {
    return no_solution("there are no readings on any feature, and so nothing to tell an arm by");
  }
  if (const double length = reach(arm); !(length > shortest_arm && length < longest_arm)) {
    return bad_input(
        fmt::format("the arm \"{}\" would reach {:.3g} mm, expected {} mm to {} mm; is a unit of its file "
                    "wrong?",
                    arm.name, length, shortest_arm, longest_arm));
  }
  CouplingAnalysis analysis;
  Coupling& coupling = analysis.coupling;
  for (const auto& parameter : all_parameters(arm)) {
    const bool is_known = parameter.kind == ParameterKind::Radius || parameter.is_joint_error();
    const bool asked = !is_known || contains(options.beside_asked, parameter.name);
    if (asked && !contains(options.not_asked, parameter.name)) {
      coupling.parameters.push_back(parameter);
    }
  }
  coupling.angle_scale = options.angle_scale > 0.0 ? options.angle_scale : reach(arm);
  System system = make_system(recording, constraints, arm, coupling.parameters, coupling.angle_scale);
  auto unknowns = settle(system, arm, recording);
  if (!unknowns) {
    return tl::unexpected(unknowns.error());
  }
  satisfy_distances(constraints, *unknowns);
  coupling.readings_not_moved = make_consistent(system, recording, arm, *unknowns);
  coupling.residual_count = constraints.residual_count();
  coupling.unknown_count = constraints.unknown_count();

  // Weights are inverse standard deviations; times the noise, singular values are in mm per mm.
  const Weights weights = first_weights(system, arm, *unknowns, options.noise);
  Linearisation linearisation = linearise(system, weights, Loss::None, arm, *unknowns);
  const Eigen::MatrixXd triangle = typical_noise(weights) * arm_triangle(linearisation, system.arm_size());
  const Svd decomposition = svd(triangle);
  coupling.singular_values = decomposition.values;
  coupling.rank =
      static_cast<int>((coupling.singular_values.array() > options.lost_below * coupling.singular_values[0]).count());

  std::vector<std::string> order = options.rather_held;
  for (const auto& name : default_hold_order(arm)) {
    if (!contains(options.rather_free, name)) {
      order.push_back(name);
    }
  }
  const Eigen::MatrixXd& v = decomposition.right_vectors;
  const Eigen::MatrixXd null_space = v.rightCols(v.cols() - coupling.rank);
  const auto lost_scaled =
      reduce(null_space, indices_of(coupling.parameters, order), indices_of(coupling.parameters, options.rather_free));
  for (const auto& motion : lost_scaled) {
    coupling.lost.push_back(in_real_units(motion, system.scale));
  }
  // What of the growth is not lost anyway.
  const Eigen::VectorXd growth = scale_motion(arm, coupling.parameters, system.scale);
  const Eigen::VectorXd seen = growth - null_space * (null_space.transpose() * growth);
  find_weak(v, system.scale, seen, lost_scaled, options.weak_below, coupling);
  if (growth.norm() > 0.0 && scale_is_asked(arm, coupling.parameters) &&
      seen_beside_radii(growth, null_space, coupling.parameters).norm() < 1e-6 * growth.norm()) {
    coupling.scale = ScaleState::Lost;
  } else if (std::any_of(coupling.weak.begin(), coupling.weak.end(),
                         [](const WeakDirection& weak) { return weak.share_of_scale > 0.7; })) {
    coupling.scale = ScaleState::Weak;
  }
  if (is_as_read(constraints)) {
    analysis.as_read = std::move(linearisation);
  }
  return analysis;
}

Expected<Coupling> analyse_coupling(const Recording& recording, const Constraints& constraints, const Arm& arm,
                                    const CouplingOptions& options) {
  return analyse(recording, constraints, arm, options).map([](CouplingAnalysis&& analysis) {
    return std::move(analysis.coupling);
  });
}

}  // namespace artcal
