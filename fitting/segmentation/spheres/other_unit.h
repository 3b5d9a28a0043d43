#pragma once

#include <optional>
#include <string>

#include "fitting/segmentation/segment.h"

namespace artcal {

/// What went wrong with the unit, such as "metres read as millimetres", if it shows: spheres of these radii are found
/// once the points are taken for that; none if not.
std::optional<std::string> other_unit(const Points& points, const ScanContents& wanted, const SegmentOptions& options);

}  // namespace artcal
