#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/large_pages.h"
#include "core/parallel.h"
#include "fitting/point_blocks.h"

namespace artcal::fitting {

/// The columns of `points` that `which` names, in its order; shape (3, which.size()).
template <typename Points>
Eigen::Matrix3Xd chosen_points(const Points& points, const std::vector<int>& which) {
  Eigen::Matrix3Xd some(3, static_cast<Eigen::Index>(which.size()));
  prefer_large_pages(some.data(), static_cast<std::size_t>(some.size()) * sizeof(double));
  parallel_blocks(which.size(), points_of_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      some.col(static_cast<Eigen::Index>(i)) = points.col(which[i]);
    }
  });
  return some;
}

}  // namespace artcal::fitting
