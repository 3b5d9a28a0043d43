#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "identification/problem/tips.h"

namespace artcal {

/// Parallel planes through the readings of one group: the axis from all readings together, each about the mean
/// of its own plane and probe; then on which side of each plane the tip was, and where the plane is.
///
/// The side is told by the certified distances: with the tip on the outer sides of two faces its centres are
/// further apart by its diameter than the faces, on the inner sides nearer. Certified normals tell whether two
/// faces look the same way. For a plane alone the side matters only where tips of different size touched it, and
/// then it is the one where these agree.
///
/// Faces of a gauge have certified sides and heights; its axis then points to where these rise.
///
/// No solution, as a sentence about `called`: readings on a line; an arm that misses a certified distance by so
/// much that the side cannot be determined.
Expected<GroupState> estimate_planes(const std::vector<Tips>& planes, const Constraints& constraints,
                                     const std::string& called);

}  // namespace artcal
