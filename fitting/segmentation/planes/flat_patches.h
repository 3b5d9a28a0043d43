#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fitting/segmentation/votes/voxel_grid.h"

namespace artcal::segmentation {

/// Small pieces of a scan that are flat, each with the points whose surroundings it describes.
struct FlatPatches {
  Eigen::Matrix3Xd centroids;  ///< mm
  Eigen::Matrix3Xd normals;    ///< unit
  double noise = 0.0;          ///< median standard deviation across them, mm

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> points_of(std::size_t patch) const {
    return std::span(members).subspan(first[patch], first[patch + 1] - first[patch]);
  }

  std::vector<std::uint32_t> members;    ///< columns of points, patch by patch
  std::vector<std::size_t> first = {0};  ///< where each patch's begin; one more at the end
};

/// The cubes of a grid that hold something flat: for scans, where the points lie densely.
FlatPatches flat_cubes(const VoxelGrid& grid);

/// Each of the `candidates` (columns, at most some thousand) whose `neighbours` nearest ones lie with it on something
/// flat: for few points, which no size of cube suits. Time goes with the square of their number.
FlatPatches flat_neighbourhoods(const Points& points, const std::vector<int>& candidates, int neighbours);

}  // namespace artcal::segmentation
