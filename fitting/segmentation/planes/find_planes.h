#pragma once

#include <string>
#include <vector>

#include "fitting/fit.h"

namespace artcal {

/// A plane in a scan.
struct FoundPlane {
  Fitted<Plane> fitted;     ///< of `points`, in their order
  std::vector<int> points;  ///< columns of its points, ascending
};

struct PlaneSearch {
  int count = 1;       ///< planes wanted, ≥ 0
  double patch = 3.0;  ///< edge of the cubes whose points are looked at together, mm: well above the points' spacing
  std::vector<int> taken;  ///< columns that belong to something else, ascending
};

/// Finds the largest planes of a scan, most points first: at most `count`, fewer where there are no more. A point
/// belongs to a plane if it lies within four standard deviations of it, and if the points of its cube lie along it:
/// where another surface comes in, its points have no part in it. Cubes of twice and more the size follow where planes
/// are missing, and single points with their neighbours where few are left. A plane has 20 points or more and is not
/// curved (curved.h).
///
/// PCL's sample consensus, seeded always the same, proposes planes through a thinned, centred float copy, to no less
/// than what floats round; the points are chosen and fitted in double. Errors: as find_spheres.
Expected<std::vector<FoundPlane>> find_planes(const Points& points, const PlaneSearch& search);

}  // namespace artcal
