#pragma once

#include <cstddef>
#include <numeric>
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

/// The columns i of `points` with takes(i), in their order, without a list of them between.
template <typename Points, typename Takes>
Eigen::Matrix3Xd points_where(const Points& points, const Takes& takes) {
  const auto count = static_cast<std::size_t>(points.cols());
  const auto sizes = of_each_block<Eigen::Index>(count, [&](std::size_t begin, std::size_t end) {
    Eigen::Index size = 0;
    for (std::size_t i = begin; i < end; ++i) {
      size += takes(i) ? 1 : 0;
    }
    return size;
  });
  Eigen::Matrix3Xd some(3, std::accumulate(sizes.begin(), sizes.end(), Eigen::Index{0}));
  prefer_large_pages(some.data(), static_cast<std::size_t>(some.size()) * sizeof(double));
  std::vector<Eigen::Index> firsts(sizes.size());
  std::exclusive_scan(sizes.begin(), sizes.end(), firsts.begin(), Eigen::Index{0});
  parallel_blocks(count, points_of_a_block, [&](std::size_t begin, std::size_t end) {
    Eigen::Index at = firsts[begin / points_of_a_block];
    for (std::size_t i = begin; i < end; ++i) {
      if (takes(i)) {
        some.col(at++) = points.col(static_cast<Eigen::Index>(i));
      }
    }
  });
  return some;
}

}  // namespace artcal::fitting
