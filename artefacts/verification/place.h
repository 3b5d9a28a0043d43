#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/recording/recording.h"

namespace artcal {

/// Where in the arm's volume something was measured: errors of an arm depend on it.
struct Place {
  Eigen::Vector3d point_in_base = Eigen::Vector3d::Zero();
  int octant = 0;             ///< 1 … 8 about the shoulder: +x+y above is 1, on by quarter turns; below 5 … 8
  double share_of_reach = 0;  ///< distance from the shoulder over the arm's reach; 0: the arm is not known
  bool above_base = false;    ///< nearly on the first axis, where its angle says nothing
  int joint_at_stop = 0;      ///< number (from 1) of a joint near the end of its travel; 0: none
};

/// Of a point that these readings measured. REQUIRES: readings is not empty.
Place place_of(const Eigen::Vector3d& point_in_base, const Recording& recording, const Arm& arm,
               const std::vector<int>& readings);

/// "octant 3, 64 % of reach", and what to beware of.
std::string text_of(const Place& place);

}  // namespace artcal
