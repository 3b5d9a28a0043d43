#pragma once

#include <vector>

#include "fitting/cloud.h"
#include "fitting/least_squares/round_state.h"

namespace artcal::fitting {

/// Surfaces of revolution to start from: every direction of a fixed net over the half sphere gets its
/// closed-form section, and the surface through a paraboloid at the centroid gives the directions that a
/// small patch needs. Nothing in them comes from a guess about the data; the best `count` by the squared
/// distances of the points are returned, best first.
std::vector<RoundState> start_cylinders(const Cloud& cloud, int count);
std::vector<RoundState> start_cones(const Cloud& cloud, int count);

/// At most `count` points of the cloud, picked in a fixed irregular order, in the cloud's own coordinates.
Cloud thinned(const Cloud& cloud, Eigen::Index count);

}  // namespace artcal::fitting
