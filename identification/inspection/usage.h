#pragma once

#include <vector>

#include <Eigen/Core>

#include "acquisition/recording/recording.h"
#include "identification/inspection/finding.h"

namespace artcal {

/// How much of what an arm can do the readings used. Without joint angles nothing but the counts is known.
struct Usage {
  struct JointRange {
    double lowest = 0.0, highest = 0.0;  ///< rad, as read
    /// Share of the circle that the readings cover, by cells of 15 degrees; 0 to 1.
    double covered = 0.0;
  };
  std::vector<JointRange> joints;
  double volume_share = 0.0;  ///< of the cells of the sphere within reach that a tip was in (an octant by two shells)
  double nearest = 0.0;       ///< of the tips to the middle of the first two axes, as a share of the reach
  double farthest = 0.0;
  double orientation_share =
      0.0;  ///< of 26 directions in the base frame that the stylus pointed along, to 22.5 degrees
  /// Placements by the side of the elbow.
  int placements_left = 0, placements_right = 0, placements_both = 0;
};

/// By the nominal arm. The elbow is that of artefacts/simulation/posture.h; a placement with five readings in a hundred
/// on the other side was read on both.
Usage usage_of(const Recording& recording);

/// Placements that were read with the elbow on one side, where none or few were read on the other: remarks.
Findings find_one_sided_placements(const Recording& recording, const Usage& usage);

}  // namespace artcal
