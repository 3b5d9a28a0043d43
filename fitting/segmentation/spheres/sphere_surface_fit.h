#pragma once

#include <optional>

#include <Eigen/Core>

namespace artcal::segmentation {

/// Pulls a sphere of known radius onto the surface next to it: Gauss-Newton on the points inside a shell that
/// narrows from `width` to four standard deviations of
/// what it holds. None where the points do not hold a centre. `points`
/// lie around the start; they are not checked.
struct SphereFit {
  Eigen::Vector3d centre;
  double noise;  ///< standard deviation of the distances, from their median
};
std::optional<SphereFit> fit_to_surface(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& start, double radius,
                                        double width);

}  // namespace artcal::segmentation
