#pragma once

#include "fitting/cloud.h"

namespace artcal::fitting {

/// The plane in the middle of the two parallel planes next to each other that hold all points: exact, from the width of
/// their convex hull. In the frame and unit of the cloud; REQUIRES at least one point.
Plane minimum_zone_plane(const Cloud& cloud);

}  // namespace artcal::fitting
