#include "identification/near_the_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "identification/coupling.h"
#include "identification/problem.h"
#include "identification/residual.h"
#include "identification/settle.h"
#include "identification/tips.h"
#include "identification/weights.h"

namespace artcal {
namespace {

/// How large the rms deviation of a ball's readings may be.
struct Bound {
  double share;            ///< of the ball's and the tip's radius together
  bool without_certified;  ///< also where the ball's radius is unknown: then of the tip's alone
};
// Below this the readings are surely on the side of the ball where the arm has them. Of a ball of unknown size at least
// the tip is known; where that is a point, any readings may be another ball.
constexpr Bound round_enough{0.03, true};
// Contacts all over a ball are one radius from their mean: what scatters more is read with an arm that misses it.
constexpr Bound any_ball{1.1, false};
// What counts as far off, mm, round by round: a wide loss finds the way, a narrow one lets go of balls on the wrong
// side.
constexpr double rounds[] = {3.0, 3.0, 1.0, 1.0, 0.3, 0.3, 0.3};
constexpr int iterations = 25;
constexpr double near_enough = 0.01;  // mm; the identification that follows takes it from there

/// An arm, and how many balls it does not see yet.
struct Near {
  Arm arm;
  int unseen = std::numeric_limits<int>::max();
};

double rms_of(const Tips& tips, const Unknowns& unknowns) {
  const FeatureConstraint& feature = *tips.feature;
  const GroupState none;
  const GroupState& group = feature.group < 0 ? none : unknowns.groups[feature.group];
  const FeatureResidual residual(feature, group.reference, group.values.data(), unknowns.shared.data());
  double squares = 0.0;
  for (int k = 0; k < feature.size(); ++k) {
    const Residual r = residual.at(k, tips.centres.col(k), tips.radii[k], false);
    squares += r.value.head(r.rows).squaredNorm();
  }
  return std::sqrt(squares / feature.size());
}

// Balls of `constraints` whose readings are beyond the bound; tips and unknowns are of the features as they are taken.
int count_beyond(const Bound& bound, const Constraints& constraints, const std::vector<Tips>& tips,
                 const Unknowns& unknowns) {
  int count = 0;
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    if (feature.demand == Demand::OnBall && (feature.radius > 0.0 || bound.without_certified)) {
      const bool within = rms_of(tips[f], unknowns) < bound.share * (feature.radius + tips[f].radii[0]);
      count += within ? 0 : 1;
    }
  }
  return count;
}

int count_beyond(const Bound& bound, const Recording& recording, const Constraints& constraints,
                 const Constraints& taken_as, const Arm& arm) {
  const System system = make_system(recording, taken_as, arm, {});
  const auto tips = all_tips(system, arm);
  const auto unknowns = settle(system, arm, recording, tips);
  return unknowns ? count_beyond(bound, constraints, tips, *unknowns) : std::numeric_limits<int>::max();
}

// The free parameters that these constraints tell at this arm; nothing where the analysis finds no solution.
std::optional<std::vector<Parameter>> told(const Recording& recording, const Constraints& constraints, const Arm& arm,
                                           const Selection& selection) {
  const auto coupling = analyse_coupling(recording, constraints, arm, coupling_options(selection));
  const auto free = coupling ? free_parameters(selection, *coupling) : tl::unexpected(coupling.error());
  return free ? std::optional(*free) : std::nullopt;
}

// The arm fitted to balls taken for points. Certified distances count as the readings do: held to a micrometre,
// they would bind the middles of half balls to what is true of centres, and the solver would creep along them.
std::optional<Arm> fitted_to_points(const Recording& recording, const Constraints& points, const Arm& start,
                                    const Selection& selection) {
  const auto free = told(recording, points, start, selection);
  if (!free) {
    return std::nullopt;
  }
  const System system = make_system(recording, points, start, *free);
  auto unknowns = settle(system, start, recording);
  if (!unknowns) {
    return std::nullopt;
  }
  const Solution solution = solve(system, unit_weights(points), Eigen::VectorXd::Zero(system.arm_size()),
                                  std::move(*unknowns), {Loss::None, 100, near_enough});
  return solution.termination == Termination::Failed ? std::nullopt : std::optional(system.arm_at(solution.x.data()));
}

// Readings count by what is far off, and what is certified by no more than the readings on it: held to a micrometre,
// more distances than the centres on a line need are a valley that is flat across and takes twice the steps.
Weights weights_of(const Constraints& constraints, double far_off) {
  Weights weights = uniform_weights(constraints, far_off);
  const Weights unit = unit_weights(constraints);
  for (std::size_t d = 0; d < weights.distances.size(); ++d) {
    weights.distances[d] = std::min(weights.distances[d], unit.distances[d] / far_off);
  }
  for (std::size_t s = 0; s < weights.shared.size(); ++s) {
    weights.shared[s] = std::min(weights.shared[s], unit.shared[s] / far_off);
  }
  return weights;
}

// Fits with a loss that lets go of balls on the wrong side, and settles these anew, until all are seen.
Near approach(const Recording& recording, const Constraints& constraints, const Arm& start,
              const Selection& selection) {
  const auto free = told(recording, constraints, start, selection);
  Near near{start};
  if (!free) {
    return near;
  }
  const System system = make_system(recording, constraints, start, *free);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.arm_size());
  auto unknowns = settle(system, start, recording);
  for (const double far_off : rounds) {
    if (!unknowns || near.unseen == 0) {
      break;
    }
    const Solution solution = solve(system, weights_of(constraints, far_off), x, std::move(*unknowns),
                                    {Loss::Cauchy, iterations, near_enough});
    if (solution.termination == Termination::Failed) {
      break;
    }
    x = solution.x;
    near.arm = system.arm_at(x.data());
    const auto tips = all_tips(system, near.arm);
    unknowns = settle(system, near.arm, recording, tips);
    near.unseen = unknowns ? count_beyond(round_enough, constraints, tips, *unknowns) : std::numeric_limits<int>::max();
  }
  return near;
}

}  // namespace

Arm arm_near_the_balls(const Recording& recording, const Constraints& constraints, const Arm& start,
                       const Selection& selection) {
  const bool has_balls = std::any_of(constraints.features.begin(), constraints.features.end(),
                                     [](const FeatureConstraint& feature) { return feature.demand == Demand::OnBall; });
  if (!has_balls) {
    return start;
  }
  Near best{start, count_beyond(round_enough, recording, constraints, constraints, start)};
  const auto try_from = [&](const Arm& arm) {
    Near near = approach(recording, constraints, arm, selection);
    if (near.unseen < best.unseen) {
      best = std::move(near);
    }
  };
  if (best.unseen == 0) {
    return start;
  }
  const Constraints points = balls_as_points(constraints);
  const bool misses = count_beyond(any_ball, recording, constraints, points, start) > 0;
  if (!misses) {
    try_from(start);
  }
  if (best.unseen > 0) {
    if (const auto by_points = fitted_to_points(recording, points, start, selection)) {
      if (misses) {
        best.arm = *by_points;
      }
      try_from(*by_points);
    }
  }
  return best.arm;
}

}  // namespace artcal
