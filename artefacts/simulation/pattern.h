#pragma once

#include <vector>

#include <Eigen/Core>

#include "artefacts/simulation/plan/plan.h"
#include "core/random.h"

namespace artcal {

/// Unit directions of the 25 points about the pole z: the pole, 4 at 22.5° from it, 8 at 45°, 4 at 67.5°, 8 at 90°,
/// each ring turned by 22.5° against the one before (docs/verification.md).
std::vector<Eigen::Vector3d> iso_directions();

/// Unit directions from a ball's centre to where it is touched, in the base frame. Iso25: iso_directions() about the
/// probing's pole. Spread: uniform over the cap and evenly spaced; of a scan at random.
std::vector<Eigen::Vector3d> directions_on_ball(const PlannedProbing& probing, RandomStream& random);

/// Standard deviation of a ball's centre in its worst direction over that of one touch, where its diameter is fitted
/// too (docs/verification.md); infinite where the touches do not determine it.
double centre_dilution(const std::vector<Eigen::Vector3d>& directions);

/// Places on a plane's rectangle, uniform, in the frame of the plane's normal: (x, y) of two unit vectors
/// across it, mm.
std::vector<Eigen::Vector2d> places_on_plane(const PlannedProbing& probing, RandomStream& random);

/// A rotation that takes z to the unit vector `axis`.
Eigen::Matrix3d rotation_to(const Eigen::Vector3d& axis);

}  // namespace artcal
