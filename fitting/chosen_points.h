#pragma once

#include <vector>

#include <Eigen/Core>

namespace artcal::fitting {

/// The columns of `points` that `which` names, in its order; shape (3, which.size()).
template <typename Points>
Eigen::Matrix3Xd chosen_points(const Points& points, const std::vector<int>& which) {
  Eigen::Matrix3Xd some(3, static_cast<Eigen::Index>(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i) {
    some.col(static_cast<Eigen::Index>(i)) = points.col(which[i]);
  }
  return some;
}

}  // namespace artcal::fitting
