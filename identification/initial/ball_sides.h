#pragma once

#include <vector>

#include <Eigen/Core>

#include "identification/problem/system.h"
#include "identification/problem/tips.h"

namespace artcal {

/// Readings of a ball that lie nearly in one plane fit a centre on either side of it about as well. Where they do not
/// decide, because the two sums of squares differ by less than noise makes of them, moves the centre to the side that
/// certified coordinates or distances agree with. `centres` are those of all features by their own readings
/// (Constraints::features), mm, base frame; `certified` where the settled artefact has them.
void choose_sides(const Constraints& constraints, const std::vector<Tips>& tips, const Unknowns& unknowns,
                  const std::vector<Eigen::Vector3d>& certified, std::vector<Eigen::Vector3d>& centres);

}  // namespace artcal
