#include "identification/identifiability/weak_parameters.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "identification/identifiability/svd.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/problem.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

constexpr double prior_length = 10.0;                // mm
constexpr double prior_angle = 3.0 * units::degree;  // rad
// A preferred parameter is fixed where its part in a direction is at least this share of the largest.
constexpr double good_part = 0.3;
constexpr double tip_preference = 0.1;
// An arm whose scale is known worse than to 0.4 % is of no use, and its fit is biased: lengths shrink
// to absorb noise.
constexpr double max_scale_uncertainty = 4e-3;

// The higher, the rather fixed: lengths of outer joints first, a before d; then a tip, then all others.
double preference(const Parameter& parameter) {
  if (parameter.kind == ParameterKind::A) {
    return 2.0 * parameter.owner + 2.0;
  }
  if (parameter.kind == ParameterKind::D) {
    return 2.0 * parameter.owner + 1.0;
  }
  return parameter.is_tip() ? tip_preference : 0.0;
}

// Index of the parameter to fix for a direction (unit, in prior standard deviations).
int leading(const Eigen::VectorXd& direction, const std::vector<Parameter>& free) {
  Eigen::Index best = 0;
  const double largest = direction.cwiseAbs().maxCoeff(&best);
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    if (std::abs(direction[i]) >= good_part * largest &&
        preference(free[static_cast<std::size_t>(i)]) > preference(free[static_cast<std::size_t>(best)])) {
      best = i;
    }
  }
  return static_cast<int>(best);
}

// The growth of all lengths in proportion, in prior standard deviations.
Eigen::VectorXd growth_of(const Arm& arm, const std::vector<Parameter>& free) {
  Eigen::VectorXd expansion_factor = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(free.size()));
  for (std::size_t i = 0; i < free.size(); ++i) {
    expansion_factor[static_cast<Eigen::Index>(i)] = free[i].is_length() ? value(arm, free[i]) / prior_length : 0.0;
  }
  return expansion_factor;
}

// Whether the relative uncertainty of the common growth of all lengths is above the bound: with the growth g and the
// covariance C = Σ vᵢvᵢᵀ·(noise/σᵢ)² in prior standard deviations, √(gᵀCg)/|g|².
bool scale_is_weak(const Eigen::MatrixXd& triangle, const Eigen::VectorXd& expansion_factor, double noise) {
  const double size = expansion_factor.squaredNorm();
  const Svd decomposition = svd(triangle);
  double variance = 0.0;
  for (Eigen::Index i = 0; i < decomposition.values.size(); ++i) {
    const double part = decomposition.right_vectors.col(i).dot(expansion_factor);
    variance += std::pow(noise * part / std::max(decomposition.values[i], 1e-300), 2);
  }
  return size > 0.0 && !(std::sqrt(variance) <= max_scale_uncertainty * size);
}

// Takes one parameter a weak direction, each time from the directions of the parameters left.
void take_weak(Eigen::MatrixXd triangle, std::vector<Parameter> free, double noise, WeakParameters& weak) {
  while (free.size() > 1) {
    const Svd decomposition = svd(triangle);
    const Eigen::Index last = decomposition.values.size() - 1;
    if (decomposition.values[last] >= noise) {
      break;
    }
    const Eigen::VectorXd direction = decomposition.right_vectors.col(last);
    const int index = leading(direction, free);
    weak.names.push_back(free[static_cast<std::size_t>(index)].name);
    free.erase(free.begin() + index);
    const Eigen::Index after = triangle.cols() - 1 - index;
    triangle.middleCols(index, after) = Eigen::MatrixXd(triangle.rightCols(after));
    triangle.conservativeResize(Eigen::NoChange, triangle.cols() - 1);
  }
}

}  // namespace

double prior_deviation(const Parameter& parameter) {
  return parameter.is_length() ? prior_length : parameter.is_angle() ? prior_angle : 0.0;
}

Eigen::VectorXd prior_weights(const std::vector<Parameter>& free, const Eigen::VectorXd& scale) {
  Eigen::VectorXd weights(scale.size());
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    const double deviation = prior_deviation(free[static_cast<std::size_t>(i)]);
    weights[i] = deviation > 0.0 ? scale[i] / deviation : 1.0 / prior_length;
  }
  return weights;
}

bool is_scale_weak(const Arm& arm, const std::vector<Parameter>& free, const Linearisation& linearisation,
                   const Eigen::VectorXd& scale) {
  const Eigen::VectorXd by_prior = prior_weights(free, scale).cwiseInverse();
  return scale_is_weak(arm_triangle(linearisation, static_cast<int>(free.size())) * by_prior.asDiagonal(),
                       growth_of(arm, free), 1.0);
}

std::optional<WeakParameters> find_weak_parameters(const Recording& recording, const Constraints& constraints,
                                                   const Arm& start, const std::vector<Parameter>& free,
                                                   const Noise& noise) {
  const System system = make_system(recording, constraints, start, free);
  auto unknowns = estimate_nuisance_parameters(system, start, recording);
  if (!unknowns) {
    return std::nullopt;
  }
  const Weights weights = first_weights(system, start, *unknowns, noise);
  SolveOptions options;
  options.prior_weights = prior_weights(system);
  const Solution solution =
      solve(system, weights, Eigen::VectorXd::Zero(system.arm_size()), std::move(*unknowns), options);
  if (solution.termination == Termination::Failed || !solution.x.allFinite()) {
    return std::nullopt;
  }
  // Residuals in units of the stated noise or, where none is stated, in mm: then what the fit leaves is the noise.
  const int left = constraints.residual_count() - constraints.unknown_count() - system.arm_size();
  const double sigma =
      noise.is_given() || left < 1 ? 1.0 : std::sqrt(2.0 * solution.final_cost / static_cast<double>(left));
  const Eigen::VectorXd by_prior = options.prior_weights.cwiseInverse();
  const Arm arm = system.arm_at(solution.x.data());
  const Linearisation by_readings = linearise(system, weights, Loss::None, arm, solution.unknowns);
  const Eigen::MatrixXd triangle = arm_triangle(by_readings, system.arm_size()) * by_prior.asDiagonal();
  WeakParameters weak{arm, {}, scale_is_weak(triangle, growth_of(arm, free), sigma)};
  take_weak(triangle, free, sigma, weak);
  return weak;
}

}  // namespace artcal
