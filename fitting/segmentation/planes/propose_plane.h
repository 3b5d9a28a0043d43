#pragma once

#include <optional>
#include <vector>

#include "fitting/feature.h"

namespace artcal::segmentation {

/// A plane that many of the points not `used` yet lie within `width` of; the same points give the same plane. None
/// where fewer than three do. Rough: to be fitted.
std::optional<Plane> propose_plane(const Eigen::Matrix3Xd& points, const std::vector<char>& used, double width);

}  // namespace artcal::segmentation
