#pragma once

#include <vector>

#include <Eigen/Core>

#include "fitting/segmentation/votes/centre_votes.h"

namespace artcal::segmentation {

struct VotePeak {
  Eigen::Vector3d centre;          ///< mean of the votes that agree, about the same origin
  std::vector<std::size_t> cubes;  ///< that they come from
};

/// Places where at least `fewest` votes lie within `radius`/5, strongest first, no two nearer than `radius`.
std::vector<VotePeak> vote_peaks(const CentreVotes& votes, double radius, int fewest);

}  // namespace artcal::segmentation
