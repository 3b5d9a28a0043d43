#pragma once

#include <optional>
#include <vector>

#include "fitting/fit.h"

namespace artcal::segmentation {

/// Pulls a sphere of known radius onto the surface next to it: Gauss-Newton on the points inside a shell that
/// narrows from `width` to four standard deviations of
/// what it holds. None where the points do not hold a centre. `points`
/// lie around the start; they are not checked.
struct Settled {
  Eigen::Vector3d centre;
  double noise;  ///< standard deviation of the distances, from their median
};
std::optional<Settled> settle(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& start, double radius,
                              double width);

/// Those of `points` that are the sphere's own surface, and what that leaves.
struct Surface {
  std::vector<char> is_own;  ///< one a point
  int count = 0;             ///< of them
  Settled settled;
  double coverage = 0.0;  ///< share of the sphere that they cover
  /// Root mean square of the points' distances from the plane through the centre that they are nearest to, of the
  /// radius: a cap of 20 degrees has 0.17, a ring next to nothing.
  double narrowest = 0.0;
};

/// A point is the sphere's own if it lies within four standard deviations of it, and if the cell of directions
/// it lies in shows the sphere and nothing else: where another surface comes in (stem, table) or where readings
/// scatter (edges, mixed pixels), part of what is foreign lies within the noise and would pull the centre.
Surface own_surface(const Eigen::Matrix3Xd& points, const Settled& start, double radius);

/// How far the surface is from round beyond what noise makes of it: the root mean square of the part of the distances
/// that a quadric would explain (an ellipsoid, a cylinder, a cone that touches), mm; 0 where that part may be chance.
/// The surface's own points count, and all others within a fortieth of the radius of it.
double out_of_round(const Eigen::Matrix3Xd& points, const Surface& surface, double radius);

}  // namespace artcal::segmentation
