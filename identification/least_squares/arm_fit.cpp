#include "identification/least_squares/arm_fit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/statistics.h"
#include "identification/evaluation/stationarity.h"
#include "identification/identifiability/weak_parameters.h"
#include "identification/initial/faint_turns.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/robust_fit.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

constexpr int max_rounds = 20;
constexpr double noise_tolerance = 1e-4;     // relative change at which the noise has converged
constexpr double good_for_the_noise = 1e-4;  // mm a step moves; the rounds that follow go on from there
// Readings that agree to the last bit (simulated without noise) must not get infinite weight.
constexpr double least_noise = 1e-9;   // mm
constexpr int max_restarts = 5;        // where a solve ended short of the minimum
constexpr double no_residuals = 1e-6;  // mm

// Factor by which the noise in use is to be multiplied so that the residuals have their expected size.
double noise_factor(const WhitenedResiduals& residuals, int degrees_of_freedom, Loss loss) {
  if (loss != Loss::None) {
    const double unbias = std::sqrt(static_cast<double>(residuals.reading_count()) / degrees_of_freedom);
    return residuals.deviation_by_median() * unbias;
  }
  const double left = std::max(0.5 * degrees_of_freedom, degrees_of_freedom - residuals.certificates_squared());
  return std::sqrt(residuals.readings_squared() / left);
}

void put_prior(const WeakPrior& prior, const System& system, SolveOptions& options) {
  if (prior.names.empty()) {
    return;
  }
  options.prior_weights = prior_weights(system);
  options.prior_at = Eigen::VectorXd::Zero(system.arm_size());
  for (int i = 0; i < system.arm_size(); ++i) {
    const Parameter& parameter = system.free[static_cast<std::size_t>(i)];
    options.prior_at[i] = (value(prior.nominal, parameter) - value(system.start, parameter)) / system.scale[i];
  }
}

// Goes on until the sum of squares is stationary, whatever parameters describe the arm. A solver that is held in a
// narrow valley by a small trust region takes steps that move nothing, and is not at its end.
Expected<ArmFit> at_minimum(const System& system, Eigen::VectorXd x, const SolveOptions& options, ArmFit fit) {
  const int unknowns = system.constraints->residual_count() - fit.degrees_of_freedom;
  for (int restart = 0;; ++restart) {
    const ResidualParts parts = residual_parts(fit.linearisation, system.arm_size());
    if (is_stationary(parts, fit.degrees_of_freedom, unknowns, options.still / fit.noise)) {
      return fit;
    }
    if (restart == max_restarts) {
      return no_convergence(
          fmt::format("the estimation did not converge: it ended where a linear step would still lower the residuals' "
                      "root mean square by {:.2g} %. Check whether parameters of the arm describe the same motion, as "
                      "d of nearly parallel axes do",
                      100.0 * (1.0 - parts.orthogonal / std::hypot(parts.orthogonal, parts.tangential))));
    }
    Solution solution = solve(system, fit.weights, x, fit.unknowns, options);
    if (solution.termination == Termination::Failed) {
      return no_convergence(fmt::format("the estimation did not converge ({})", solution.message));
    }
    take_solution(std::move(solution), system, x, fit);
  }
}

}  // namespace

void take_solution(Solution&& solution, const System& system, Eigen::VectorXd& x, ArmFit& fit) {
  ++fit.rounds;
  fit.iterations += solution.iterations;
  fit.termination = std::move(solution.message);
  fit.cost = solution.final_cost;
  x = std::move(solution.x);
  fit.unknowns = std::move(solution.unknowns);
  fit.linearisation = std::move(solution.linearisation);
  fit.arm = system.arm_at(x.data());
  fit.residuals = whitened_residuals(system, fit.weights, fit.arm, fit.unknowns);
}

Redundancy redundancy_of(const Recording& recording, const Constraints& constraints, const ArmFit& fit,
                         const std::vector<Parameter>& free) {
  System system = make_system(recording, constraints, fit.arm, free);
  system.scale = fit.scale;  // of the linearisation's columns
  return redundancy_of(system, fit.weights, fit.loss_weights, fit.linearisation, fit.arm, fit.unknowns);
}

bool contradicts(const WeakPrior& prior, const ArmFit& fit, const std::vector<Parameter>& free) {
  double squares = 0.0;
  int count = 0;
  for (const Parameter& parameter : free) {
    if (const double deviation = prior_deviation(parameter); deviation > 0.0) {
      squares += std::pow((value(fit.arm, parameter) - value(prior.nominal, parameter)) / deviation, 2);
      ++count;
    }
  }
  return count > 0 && squares > chi_squared_quantile(0.999, count);
}

Expected<ArmFit> fit_arm(const Recording& recording, const Constraints& constraints, const Arm& start,
                         const std::vector<Parameter>& free, const Noise& noise, const SolveOptions& options,
                         const WeakPrior& prior) {
  const System system = make_system(recording, constraints, start, free);
  auto unknowns = estimate_nuisance_parameters(system, start, recording);
  if (!unknowns) {
    return tl::unexpected(unknowns.error());
  }
  ArmFit fit;
  const int residuals = constraints.residual_count();
  fit.degrees_of_freedom =
      residuals - constraints.unknown_count() - system.arm_size() + static_cast<int>(prior.names.size());
  if (fit.degrees_of_freedom < 1) {
    return no_solution(
        fmt::format("{} residuals cannot determine {} parameters and {} unknown coordinates with "
                    "anything left to judge them by; take more readings or fix parameters",
                    residuals, system.arm_size(), constraints.unknown_count()));
  }
  fit.arm = start;
  fit.unknowns = std::move(*unknowns);
  fit.weights = first_weights(system, fit.arm, fit.unknowns, noise);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.arm_size());
  double sigma = 1.0;
  Loss first_loss = options.loss;
  if (options.loss != Loss::None && !noise.is_given()) {
    // Least squares first would follow what the loss is there to let go of: the start's own residuals say what is far.
    fit.residuals = whitened_residuals(system, fit.weights, fit.arm, fit.unknowns);
    const double seen = noise_factor(fit.residuals, fit.degrees_of_freedom, options.loss);
    if (seen > no_residuals) {
      sigma = seen;
      fit.weights = uniform_weights(constraints, sigma);
    } else {
      first_loss = Loss::None;  // readings that are each alone on their point: only what is certified is off
    }
  }
  for (bool standing = false; !standing && fit.rounds < max_rounds;) {
    const bool noise_is_known = noise.is_given() || fit.rounds > 0;
    SolveOptions round{first_loss, options.max_iterations, noise_is_known ? options.still : good_for_the_noise};
    const bool another_follows = fit.rounds == 0 && !noise.reading && options.loss == Loss::None;
    round.linearise_solution = !another_follows;
    put_prior(prior, system, round);
    Solution solution = solve(system, fit.weights, x, fit.unknowns, patient_options(constraints, round));
    solution = with_corrected_turns(std::move(solution), system, recording, fit.weights, x, round);
    const bool is_usable = options.loss != Loss::None && solution.termination == Termination::NoConvergence;
    if (solution.termination != Termination::Converged && !is_usable) {
      return no_convergence("the estimation did not converge to an arm");
    }
    take_solution(std::move(solution), system, x, fit);
    fit.loss_weights = loss_weights(constraints, fit.weights, round.loss, fit.residuals);
    if (options.loss != Loss::None) {
      // Near enough for robust_fit() to go on from.
      if (noise.encoder) {
        fit.weights = posture_weights(system, fit.arm, fit.unknowns, *noise.encoder, *noise.probing);
        fit.residuals = whitened_residuals(system, fit.weights, fit.arm, fit.unknowns);
      }
      break;
    }
    if (noise.reading) {
      standing = true;
    } else if (noise.encoder) {
      // Once more with the noise at the identified arm's postures.
      standing = fit.rounds == 2;
      if (!standing) {
        fit.weights = posture_weights(system, fit.arm, fit.unknowns, *noise.encoder, *noise.probing);
      }
    } else {
      const double better =
          std::max(least_noise, sigma * noise_factor(fit.residuals, fit.degrees_of_freedom, options.loss));
      standing = fit.rounds > 1 && std::abs(better - sigma) <= noise_tolerance * sigma;
      if (!standing) {
        sigma = better;
        fit.weights = uniform_weights(constraints, sigma);
      }
    }
  }
  fit.scale = system.scale;
  fit.noise = typical_noise(fit.weights);
  fit.counted = fit.weights;
  if (options.loss == Loss::None) {
    SolveOptions again = options;
    put_prior(prior, system, again);
    return at_minimum(system, x, again, std::move(fit));
  }
  SolveOptions robust = options;
  put_prior(prior, system, robust);
  return robust_fit(system, noise, robust, x, std::move(fit));
}

}  // namespace artcal
