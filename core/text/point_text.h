#pragma once

#include <string>

#include <Eigen/Core>

namespace artcal {

/// A value with as many decimals as show `resolution`, which is in the same unit: 12.3456 to 0.01 is "12.35". Six
/// significant digits of a coordinate far from the origin would hide what a message is about. REQUIRES resolution > 0.
std::string decimals_text(double value, double resolution);

/// A point as "(x, y, z)", each coordinate to `resolution`.
std::string point_text(const Eigen::Vector3d& point, double resolution);

}  // namespace artcal
