#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm.h"
#include "core/random.h"

namespace artcal {

/// Every joint anywhere on its circle, rad.
Eigen::VectorXd random_posture(const Arm& arm, RandomStream& random);

/// Joint angles with the tip at a place of the base frame, from random starts; nothing where twenty of them lead
/// nowhere.
std::optional<Eigen::VectorXd> posture_at(const Arm& arm, int probe, const Eigen::Vector3d& place_in_base,
                                          RandomStream& random);

/// Directions from a sphere's centre: the pole z, then rings of 4, 8, 4 and 8 points, each turned by 22.5 degrees
/// against the one before (docs/verification.md).
std::vector<Eigen::Vector3d> pattern_of_25();

}  // namespace artcal
