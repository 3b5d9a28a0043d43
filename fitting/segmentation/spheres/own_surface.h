#pragma once

#include <vector>

#include <Eigen/Core>

#include "fitting/segmentation/spheres/sphere_surface_fit.h"

namespace artcal::segmentation {

/// Those of `points` that are the sphere's own surface, and what that leaves.
struct Surface {
  std::vector<char> is_own;  ///< one a point
  int count = 0;             ///< of them
  SphereFit sphere;
  double coverage = 0.0;  ///< share of the sphere that they cover
  /// Root mean square of the points' distances from the plane through the centre that they are nearest to, of the
  /// radius: a cap of 20 degrees has 0.17, a ring next to nothing.
  double narrowest = 0.0;
};

/// A point is the sphere's own if it lies within four standard deviations of it, and if the cell of directions
/// it lies in shows the sphere and nothing else: where another surface comes in (stem, table) or where readings
/// scatter (edges, mixed pixels), part of what is foreign lies within the noise and would pull the centre.
Surface own_surface(const Eigen::Matrix3Xd& points, const SphereFit& start, double radius);

}  // namespace artcal::segmentation
