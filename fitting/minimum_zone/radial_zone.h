#pragma once

#include "core/error.h"
#include "fitting/minimum_zone/minimum_circumscribed.h"

namespace artcal::fitting {

/// The shell of least thickness that holds all points, and the largest ball that holds none, both as the
/// optimum next to `start` (the least-squares centre): farther off there are always others, such as
/// the shells of huge radius that see any points as flat. In the frame and unit of the points, which are centred and of
/// size about one; REQUIRES at least one point. NoSolution if the centre runs away.
template <int Dimension>
Expected<Ball<Dimension>> minimum_zone(const BallPoints<Dimension>& points,
                                       const Eigen::Matrix<double, Dimension, 1>& start);
template <int Dimension>
Expected<Ball<Dimension>> maximum_inscribed(const BallPoints<Dimension>& points,
                                            const Eigen::Matrix<double, Dimension, 1>& start);

}  // namespace artcal::fitting
