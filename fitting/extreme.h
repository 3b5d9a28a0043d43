#pragma once

#include <Eigen/Core>

#include "core/error.h"
#include "fitting/cloud.h"

namespace artcal::fitting {

/// The fits that a few extreme points decide. All in the frame and unit of the given points, which are
/// centred and of size about one; REQUIRES at least one point.

/// The two parallel planes next to each other that hold all points: exact, from the width of their convex
/// hull. The plane returned is the one in the middle.
Plane minimum_zone_plane(const Cloud& cloud);

/// A ball of Dimension 2 (a disc) or 3.
template <int Dimension>
struct Ball {
  Eigen::Matrix<double, Dimension, 1> centre;
  double radius;
};
template <int Dimension>
using BallPoints = Eigen::Matrix<double, Dimension, Eigen::Dynamic>;

/// The smallest ball that holds all points; unique, and no search is needed.
template <int Dimension>
Ball<Dimension> minimum_circumscribed(const BallPoints<Dimension>& points);

/// The shell of least thickness that holds all points, and the largest ball that holds none, both as the
/// optimum next to `start` (the least-squares centre): farther off there are always others, such as
/// the shells of huge radius that see any points as flat. NoSolution if the centre runs away.
template <int Dimension>
Expected<Ball<Dimension>> minimum_zone(const BallPoints<Dimension>& points,
                                       const Eigen::Matrix<double, Dimension, 1>& start);
template <int Dimension>
Expected<Ball<Dimension>> maximum_inscribed(const BallPoints<Dimension>& points,
                                            const Eigen::Matrix<double, Dimension, 1>& start);

}  // namespace artcal::fitting
