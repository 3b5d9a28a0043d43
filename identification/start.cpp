#include "identification/start.h"

#include <algorithm>

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

// Contact points all over a ball have an rms distance of one radius from their mean, of a part of it less.
constexpr double balls_still_seen = 1.1;
// Where the radius is not known, the deviation from the best sphere tells, against that sphere's own radius.
constexpr double roundness_still_seen = 0.25;

bool sees_the_balls(const Recording& recording, const Constraints& constraints, const Evaluation& as_points,
                    const Arm& arm) {
  const System system = make_system(recording, constraints, arm, {});
  const auto unknowns = settle(system, arm, recording);
  const auto as_balls = evaluate(recording, constraints, arm);
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    if (feature.demand != Demand::OnBall) {
      continue;
    }
    const double tip_radius = arm.probes[recording.readings[feature.readings.front()].probe].radius;
    if (feature.radius > 0.0 ? as_points.features[f].rms > balls_still_seen * (feature.radius + tip_radius)
                             : !unknowns || !as_balls ||
                                   as_balls->features[f].rms >
                                       roundness_still_seen * (unknowns->shared[feature.shared_radius] + tip_radius)) {
      return false;
    }
  }
  return true;
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

Expected<Arm> arm_near_the_balls(const Recording& recording, const Constraints& constraints, const Arm& start,
                                 const Selection& selection) {
  const Constraints points = balls_as_points(constraints);
  const auto as_points = evaluate(recording, points, start);
  if (!as_points || sees_the_balls(recording, constraints, *as_points, start)) {
    return start;
  }
  const auto coupling = analyse_coupling(recording, points, start, coupling_options(selection));
  if (!coupling) {
    return tl::unexpected(coupling.error());
  }
  const auto free = free_parameters(selection, *coupling);
  if (!free) {
    return tl::unexpected(free.error());
  }
  Noise as_large_as_the_balls;
  as_large_as_the_balls.reading = as_points->overall.rms;
  return fit_arm(recording, points, start, *free, as_large_as_the_balls, {}).map([](const ArmFit& fit) {
    return fit.arm;
  });
}

}  // namespace artcal
