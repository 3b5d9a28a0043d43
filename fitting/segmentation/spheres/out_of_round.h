#pragma once

#include <Eigen/Core>

#include "fitting/segmentation/spheres/own_surface.h"

namespace artcal::segmentation {

/// How far the surface is from round beyond what noise makes of it: the root mean square of the part of the distances
/// that a quadric would explain (an ellipsoid, a cylinder, a cone that touches), mm; 0 where that part may be chance.
/// The surface's own points count, and all others within a fortieth of the radius of it.
double out_of_round(const Eigen::Matrix3Xd& points, const Surface& surface, double radius);

}  // namespace artcal::segmentation
