#pragma once

#include "core/error.h"
#include "identification/problem/system.h"
#include "identification/problem/tips.h"

namespace artcal {

/// Fits what an arm's readings say of the unknown points, planes, poses and radii when the arm is held: the mean
/// of the tips for a point, least squares for all else. Certified distances take no part (but for the side of
/// planes on which the tip was), so that a length between two settled features is a measurement; certified
/// coordinates and radii count as exact.
/// No solution, by name of the feature: a centre that its readings do not determine (fewer than four,
/// or all in one plane), a pose from a single point, a plane from readings on a line.
Expected<Unknowns> estimate_nuisance_parameters(const System& system, const Arm& arm, const Recording& recording);

/// The same for who has the tips: all_tips(system, arm).
Expected<Unknowns> estimate_nuisance_parameters(const System& system, const Arm& arm, const Recording& recording,
                                                const std::vector<Tips>& tips);

/// Shifts settled points, by the least amount, so that binding distances hold exactly.
void satisfy_distances(const Constraints& constraints, Unknowns& unknowns);

}  // namespace artcal
