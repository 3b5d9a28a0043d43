#pragma once

#include <Eigen/Core>

namespace artcal::fitting {

/// A ball of Dimension 2 (a disc) or 3.
template <int Dimension>
struct Ball {
  Eigen::Matrix<double, Dimension, 1> centre;
  double radius;
};
template <int Dimension>
using BallPoints = Eigen::Matrix<double, Dimension, Eigen::Dynamic>;

/// The smallest ball that holds all points; unique, and no search is needed. In the frame and unit of the points, which
/// are centred and of size about one; REQUIRES at least one point.
template <int Dimension>
Ball<Dimension> minimum_circumscribed(const BallPoints<Dimension>& points);

}  // namespace artcal::fitting
