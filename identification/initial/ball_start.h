#pragma once

#include <optional>

#include <Eigen/Core>

namespace artcal {

/// The point at given distances (mm) from given points (columns), by least squares. Nothing where the points do
/// not determine it: fewer than four, or all in one plane. Where they miss by a fifth of the distances though half of
/// the points fit a sphere twenty times as well, some belong to another feature, and the point is that of the others.
std::optional<Eigen::Vector3d> point_at_distances(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& distances);

/// The other point at these distances, found by least squares from the mirror image of `point` in the plane that lies
/// nearest to the given points; nothing where that leads nowhere, or to `point` itself.
std::optional<Eigen::Vector3d> point_on_the_other_side(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& distances,
                                                       const Eigen::Vector3d& point);

struct Ball {
  Eigen::Vector3d centre;
  double radius = 0.0;
};

/// The ball that a tip of the given radii (mm, of each point) touched from outside with its centre at the points
/// (columns), by least squares. Nothing where they do not determine it.
std::optional<Ball> ball_touched_at(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& tip_radii);

}  // namespace artcal
