#pragma once

#include <optional>

#include <tl/expected.hpp>

#include "fitting/segmentation/find_spheres.h"
#include "fitting/segmentation/voxel_grid.h"

namespace artcal::segmentation {

/// A place that may be a sphere's centre, tried: the sphere and its points, or what it is instead; nothing where
/// it does not even look like a sphere.
std::optional<tl::expected<FoundSphere, RejectedSphere>> examine(const Points& points, const VoxelGrid& grid,
                                                                 const Eigen::Vector3d& vote, double radius,
                                                                 const SphereSearch& search);

}  // namespace artcal::segmentation
