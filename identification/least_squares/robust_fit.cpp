#include "identification/least_squares/robust_fit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "identification/least_squares/robust_weights.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

constexpr int leading_rounds = 4;  // of Huber's loss
constexpr int max_reweightings = 60;
constexpr double tolerance = 1e-3;  // change of the weights, between 0 and 1, and relative of the noise
constexpr double weights_tolerance = 0.05;
constexpr double least_scale = 1e-9;  // mm

double largest_change(const std::vector<double>& from, const std::vector<double>& to) {
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    largest = std::max(largest, std::abs(to[i] - from[i]));
  }
  return largest;
}

double largest_change(const LossWeights& from, const LossWeights& to) {
  double largest = std::max(largest_change(from.distances, to.distances), largest_change(from.shared, to.shared));
  for (std::size_t f = 0; f < from.readings.size(); ++f) {
    largest = std::max(largest, largest_change(from.readings[f], to.readings[f]));
  }
  return largest;
}

LossWeights roots(LossWeights weights) {
  const auto root = [](std::vector<double>& values) {
    std::transform(values.begin(), values.end(), values.begin(), [](double value) { return std::sqrt(value); });
  };
  root(weights.distances);
  root(weights.shared);
  std::for_each(weights.readings.begin(), weights.readings.end(), root);
  return weights;
}

}  // namespace

Expected<ArmFit> robust_fit(const System& system, const Noise& noise, const SolveOptions& options, Eigen::VectorXd x,
                            ArmFit fit) {
  const Constraints& constraints = *system.constraints;
  SolveOptions weighted = options;
  weighted.loss = Loss::None;
  double sigma = typical_noise(fit.weights);
  double change = 1.0;
  bool converged = true;
  for (int round = 0; round < max_reweightings; ++round) {
    const Redundancy redundancy =
        redundancy_of(system, fit.weights, fit.loss_weights, fit.linearisation, fit.arm, fit.unknowns);
    double noise_change = 0.0;
    if (!noise.is_given()) {
      const double better = std::max(least_scale, sigma * median_noise_factor(fit.residuals, redundancy));
      noise_change = std::abs(better / sigma - 1.0);
      sigma = better;
      fit.weights = uniform_weights(constraints, sigma);
      fit.residuals = whitened_residuals(system, fit.weights, fit.arm, fit.unknowns);
    }
    set_variances(redundancy, fit.weights);
    const Loss loss = round < leading_rounds ? Loss::Huber : options.loss;
    LossWeights next = loss_weights(constraints, fit.weights, loss, fit.residuals);
    change = std::max(largest_change(fit.loss_weights, next), noise_change);
    if (round > leading_rounds && change < tolerance && converged) {
      break;
    }
    fit.loss_weights = std::move(next);
    Solution solution =
        solve(system, multiplied(fit.weights, roots(fit.loss_weights)), x, std::move(fit.unknowns), weighted);
    if (solution.termination == Termination::Failed) {
      return no_solution(fmt::format("the robust fit broke down ({})", solution.message));
    }
    converged = solution.termination == Termination::Converged;
    take_solution(std::move(solution), system, x, fit);
  }
  if (!converged || change > weights_tolerance) {
    return no_convergence(
        fmt::format("the weights of the robust loss did not converge in {} rounds: too many readings or certificates "
                    "contradict each other to say which are right",
                    max_reweightings));
  }
  const Redundancy redundancy =
      redundancy_of(system, fit.weights, fit.loss_weights, fit.linearisation, fit.arm, fit.unknowns);
  fit.counted = counted_weights(fit.weights, options.loss, fit.loss_weights, redundancy);
  if (options.prior_weights.size() > 0) {
    // The solver adds the prior to the linearisation where it begins.
    weighted.max_iterations = 0;
    fit.linearisation = solve(system, fit.counted, x, fit.unknowns, weighted).linearisation;
  } else {
    fit.linearisation = linearise(system, fit.counted, Loss::None, fit.arm, fit.unknowns);
  }
  fit.noise = typical_noise(fit.weights);
  return fit;
}

}  // namespace artcal
