#pragma once

#include <cstddef>

#include "acquisition/point_cloud/point_cloud.h"

namespace artcal {

/// Leaves out of a cloud, in place and with a warning each, what is no measurement of its own:
///  - points at exactly (0, 0, 0), which instruments write where they measured nothing: where there are several, or one
///    that lies farther off the others' bounding box than its diagonal;
///  - points that repeat an earlier one in every coordinate and joint angle: a scanner that stands still repeats one
///    error, which independent measurements would not.
/// Where nothing but zeros is left, the cloud stays as it is.
void drop_coincident_points(PointCloud& cloud);

/// Leaves out points that repeat an earlier one in every coordinate and joint angle; the number of them.
std::size_t merge_equal_points(PointCloud& cloud);

}  // namespace artcal
