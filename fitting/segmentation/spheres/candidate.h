#pragma once

#include <tl/expected.hpp>

#include "fitting/segmentation/spheres/find_spheres.h"
#include "fitting/segmentation/votes/voxel_grid.h"

namespace artcal::segmentation {

/// A place that may be a sphere's centre.
struct Candidate {
  Eigen::Vector3d centre;    ///< as the votes have it, to a fifth of the radius
  Eigen::Matrix3Xd surface;  ///< centroids of the cubes that voted for it: pieces of its surface, few strays among them
};

/// A candidate, tried: the sphere and its points, or what it is instead, with the reason.
tl::expected<FoundSphere, RejectedSphere> examine(const Points& points, const VoxelGrid& grid,
                                                  const Candidate& candidate, double radius,
                                                  const SphereSearch& search);

}  // namespace artcal::segmentation
