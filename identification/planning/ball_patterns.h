#pragma once

#include <vector>

#include <Eigen/Core>

#include "artefacts/constraints/constraint.h"
#include "artefacts/simulation/simulate.h"
#include "identification/planning/planning.h"

namespace artcal {

/// Largest dilution of a ball's centre (artefacts/simulation/pattern.h) that a plan proposes where other touches are
/// possible; beyond it `artcal verify` shows no conformity (docs/verification.md).
inline constexpr double max_planned_dilution = 5.0;

/// Exchanges the touches `chosen` of one ball for others of `directions` (unit vectors from its centre), one by one and
/// each time the exchange that lowers the dilution of the centre most, until it is max_planned_dilution at most or no
/// exchange lowers it. Fewer than four touches determine no ball and stay as they are.
std::vector<int> spread_touches(const std::vector<Eigen::Vector3d>& directions, std::vector<int> chosen);

/// The readings `chosen` (into Recording::readings) of one placement with the touches of every ball spread out, in
/// their order; others that could be taken there are those of `possible` on the same feature.
std::vector<int> with_spread_touches(const Simulation& possible, const Constraints& constraints, int placement,
                                     const std::vector<int>& chosen);

/// The balls that `chosen` readings of one placement touch.
std::vector<PlannedBall> planned_balls(const Simulation& possible, const Constraints& constraints, int placement,
                                       const std::vector<int>& chosen);

}  // namespace artcal
