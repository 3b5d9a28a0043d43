#include "identification/start.h"

#include <algorithm>
#include <optional>
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
// Balls on the wrong side of their readings are far off by this measure, mm, the others are not.
constexpr double approach_noise = 0.3;
constexpr int approach_iterations = 25;
constexpr int approaches = 4;

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

// Contact points all over a ball have an rms distance of one radius from their mean, of a part of it less.
bool misses_the_balls(const Constraints& constraints, const Evaluation& as_points, const Arm& arm,
                      const Recording& recording) {
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    const double tip_radius = arm.probes[recording.readings[feature.readings.front()].probe].radius;
    if (feature.demand == Demand::OnBall && feature.radius > 0.0 &&
        as_points.features[f].rms > 1.1 * (feature.radius + tip_radius)) {
      return true;
    }
  }
  return false;
}

// The arm fitted to balls taken for points, with what these cannot tell held.
Expected<Arm> fitted_to_points(const Recording& recording, const Constraints& points, const Arm& start,
                               const Selection& selection, double noise) {
  const auto coupling = analyse_coupling(recording, points, start, coupling_options(selection));
  if (!coupling) {
    return tl::unexpected(coupling.error());
  }
  const auto free = free_parameters(selection, *coupling);
  if (!free) {
    return tl::unexpected(free.error());
  }
  Noise as_large_as_the_balls;
  as_large_as_the_balls.reading = noise;
  return fit_arm(recording, points, start, *free, as_large_as_the_balls, {}).map([](const ArmFit& fit) {
    return fit.arm;
  });
}

// Fits with a loss that lets go of balls on the wrong side, and settles these anew, until all are seen.
std::optional<Arm> approach(const Recording& recording, const Constraints& constraints, Arm arm,
                            const Selection& selection) {
  const auto coupling = analyse_coupling(recording, constraints, arm, coupling_options(selection));
  if (!coupling) {
    return std::nullopt;
  }
  const auto free = free_parameters(selection, *coupling);
  for (int round = 0; free && round < approaches; ++round) {
    const System system = make_system(recording, constraints, arm, *free);
    auto unknowns = settle(system, arm, recording);
    if (!unknowns) {
      return std::nullopt;
    }
    const Solution solution =
        solve(system, uniform_weights(constraints, approach_noise), Eigen::VectorXd::Zero(system.arm_size()),
              std::move(*unknowns), {Loss::Cauchy, approach_iterations});
    if (solution.termination == Termination::Failed) {
      return std::nullopt;
    }
    arm = system.arm_at(solution.x.data());
    if (sees_the_balls(recording, constraints, arm)) {
      return arm;
    }
  }
  return std::nullopt;
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
  const Constraints points = balls_as_points(constraints);
  const auto as_points = evaluate(recording, points, start);
  const bool misses = as_points && misses_the_balls(constraints, *as_points, start, recording);
  if (!misses) {
    if (auto near = approach(recording, constraints, start, selection)) {
      return std::move(*near);
    }
  }
  const auto by_points = as_points ? fitted_to_points(recording, points, start, selection, as_points->overall.rms)
                                   : Expected<Arm>(tl::unexpected(as_points.error()));
  if (by_points) {
    if (auto near = approach(recording, constraints, *by_points, selection)) {
      return std::move(*near);
    }
  }
  return misses && by_points ? *by_points : start;
}

}  // namespace artcal
