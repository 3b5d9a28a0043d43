#pragma once

#include <vector>

#include <Eigen/Core>

#include "fitting/segmentation/votes/voxel_grid.h"

namespace artcal::segmentation {

/// Where the centres of spheres of one radius may be.
struct CentreVotes {
  Eigen::Matrix3Xd places;         ///< one column a vote, about grid.origin()
  std::vector<std::size_t> cubes;  ///< the cube that each vote comes from
};

/// Each patch of surface (a cube with its neighbours) votes for the two points that lie from its centroid along its
/// normal at √(R² − trace of the patch's covariance), which for a piece of a sphere is exact. The patches of a sphere
/// agree, those of a plane or a cylinder do not. Patches flatter than a sphere of that radius can be have no vote.
CentreVotes centre_votes(const VoxelGrid& grid, double radius);

}  // namespace artcal::segmentation
