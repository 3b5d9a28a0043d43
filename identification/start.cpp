#include "identification/start.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "identification/arm_fit.h"
#include "identification/coupling.h"
#include "identification/evaluation.h"
#include "identification/linearisation.h"
#include "identification/problem.h"
#include "identification/settle.h"
#include "identification/svd.h"
#include "identification/weights.h"

namespace artcal {
namespace {

// Below this σ/σ1 the readings hardly show some direction of the tip.
constexpr double shown_well = 1e-3;

std::vector<Parameter> rough_tips(const Arm& arm, const std::vector<std::string>& held) {
  std::vector<Parameter> tips;
  for (const Parameter& parameter : parameters_of(arm)) {
    if (parameter.is_tip() && !arm.probes[parameter.owner].on_axis &&
        std::find(held.begin(), held.end(), parameter.name) == held.end()) {
      tips.push_back(parameter);
    }
  }
  return tips;
}

// Below this share of a ball's radius readings are surely on the side of it where the arm has them.
constexpr double round_enough = 0.03;
// For choosing between two starts, mm: coarse enough for arms that are still far off.
constexpr double choosing_noise = 0.05;
constexpr int choosing_iterations = 40;

bool has_balls(const Constraints& constraints) {
  return std::any_of(constraints.features.begin(), constraints.features.end(),
                     [](const FeatureConstraint& feature) { return feature.demand == Demand::OnBall; });
}

bool sees_the_balls(const Recording& recording, const Constraints& constraints, const Arm& arm) {
  const auto as_balls = evaluate(recording, constraints, arm);
  for (std::size_t f = 0; as_balls && f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    const double tip_radius = arm.probes[recording.readings[feature.readings.front()].probe].radius;
    // Of a ball of unknown size at least the tip is known; where that is a point, any readings may be another ball.
    if (feature.demand == Demand::OnBall &&
        !(as_balls->features[f].rms < round_enough * (feature.radius + tip_radius))) {
      return false;
    }
  }
  return as_balls.has_value();
}

// The free parameters fitted from a start, with what these constraints cannot tell held.
Expected<ArmFit> fitted(const Recording& recording, const Constraints& constraints, const Arm& start,
                        const Selection& selection, double noise) {
  const auto coupling = analyse_coupling(recording, constraints, start, coupling_options(selection));
  if (!coupling) {
    return tl::unexpected(coupling.error());
  }
  const auto free = free_parameters(selection, *coupling);
  if (!free) {
    return tl::unexpected(free.error());
  }
  Noise as_given;
  as_given.reading = noise;
  return fit_arm(recording, constraints, start, *free, as_given, {Loss::None, choosing_iterations});
}

}  // namespace

Expected<Arm> arm_with_fitted_tips(const Recording& recording, const Constraints& constraints, const Arm& nominal,
                                   const std::vector<std::string>& held) {
  const auto tips = rough_tips(nominal, held);
  if (tips.empty()) {
    return nominal;
  }
  const System system = make_system(recording, constraints, nominal, tips);
  auto unknowns = settle(system, nominal, recording);
  if (!unknowns) {
    return tl::unexpected(unknowns.error());
  }
  const Weights weights = unit_weights(constraints);
  const Linearisation at_nominal = linearise(system, weights, Loss::None, nominal, *unknowns);
  const Eigen::VectorXd sigma = svd(arm_triangle(at_nominal, system.arm_size())).values;
  if (sigma.minCoeff() <= shown_well * sigma.maxCoeff()) {
    return nominal;
  }
  const Solution solution =
      solve(system, weights, Eigen::VectorXd::Zero(system.arm_size()), std::move(*unknowns), {}, &at_nominal);
  return solution.termination == Termination::Converged ? system.arm_at(solution.x.data()) : nominal;
}

Arm arm_near_the_balls(const Recording& recording, const Constraints& constraints, const Arm& start,
                       const Selection& selection) {
  if (!has_balls(constraints) || sees_the_balls(recording, constraints, start)) {
    return start;
  }
  std::vector<Arm> starts{start};
  const Constraints points = balls_as_points(constraints);
  if (const auto as_points = evaluate(recording, points, start)) {
    if (const auto fit = fitted(recording, points, start, selection, as_points->overall.rms)) {
      starts.push_back(fit->arm);
    }
  }
  const Arm* best = &start;
  double least = std::numeric_limits<double>::infinity();
  for (const Arm& candidate : starts) {
    const auto fit = fitted(recording, constraints, candidate, selection, choosing_noise);
    if (fit && fit->cost < least) {
      least = fit->cost;
      best = &candidate;
    }
  }
  return *best;
}

}  // namespace artcal
