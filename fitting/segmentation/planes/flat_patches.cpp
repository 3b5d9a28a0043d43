#include "fitting/segmentation/planes/flat_patches.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>

namespace artcal::segmentation {
namespace {

constexpr double min_in_patch = 5.0;

struct Flat {
  Eigen::Vector3d centroid, normal;
  double noise;  // standard deviation across it
};

/// Collects patches; `noises` are those of all.
class Collector {
 public:
  void add(const Flat& flat, std::span<const std::uint32_t> points) {
    centroids_.push_back(flat.centroid);
    normals_.push_back(flat.normal);
    noises_.push_back(flat.noise);
    patches_.members.insert(patches_.members.end(), points.begin(), points.end());
    patches_.first.push_back(patches_.members.size());
  }
  FlatPatches finish() && {
    const auto columns = [](const std::vector<Eigen::Vector3d>& vectors) {
      return Eigen::Matrix3Xd::Map(vectors.empty() ? nullptr : vectors.front().data(), 3,
                                   static_cast<Eigen::Index>(vectors.size()));
    };
    patches_.centroids = columns(centroids_);
    patches_.normals = columns(normals_);
    if (!noises_.empty()) {
      const auto middle = noises_.begin() + static_cast<std::ptrdiff_t>(noises_.size() / 2);
      std::nth_element(noises_.begin(), middle, noises_.end());
      patches_.noise = *middle;
    }
    return std::move(patches_);
  }

 private:
  FlatPatches patches_;
  std::vector<Eigen::Vector3d> centroids_, normals_;
  std::vector<double> noises_;
};

// What the points show about `origin`, if it is flat and no line.
std::optional<Flat> flat_of(const Moments& moments, const Eigen::Vector3d& origin) {
  if (moments.count < min_in_patch) {
    return std::nullopt;
  }
  const Eigen::Vector3d mean = moments.sum / moments.count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(moments.squares / moments.count - mean * mean.transpose());
  const Eigen::Vector3d& variances = eigen.eigenvalues();
  if (!(variances(0) < 0.05 * variances(1) && variances(1) > 0.03 * variances(2))) {
    return std::nullopt;
  }
  return Flat{origin + mean, eigen.eigenvectors().col(0),
              std::sqrt(std::max(0.0, variances(0)) * moments.count / (moments.count - 3.0))};
}

}  // namespace

FlatPatches flat_cubes(const VoxelGrid& grid) {
  Collector collector;
  for (std::size_t cube = 0; cube < grid.size(); ++cube) {
    if (const auto flat = flat_of(grid.moments(cube), grid.origin())) {
      collector.add(*flat, grid.points_in(cube));
    }
  }
  return std::move(collector).finish();
}

FlatPatches flat_neighbourhoods(const Points& points, const std::vector<int>& candidates, int neighbours) {
  Collector collector;
  std::vector<std::pair<double, int>> by_distance(candidates.size());
  const auto some = std::min(candidates.size(), static_cast<std::size_t>(neighbours) + 1);  // with the point itself
  for (const int candidate : candidates) {
    const Eigen::Vector3d here = points.col(candidate);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      by_distance[i] = {(points.col(candidates[i]) - here).squaredNorm(), candidates[i]};
    }
    std::partial_sort(by_distance.begin(), by_distance.begin() + static_cast<std::ptrdiff_t>(some), by_distance.end());
    Moments moments;
    for (std::size_t i = 0; i < some; ++i) {
      moments.add(points.col(by_distance[i].second) - here);
    }
    if (const auto flat = flat_of(moments, here)) {
      const auto member = static_cast<std::uint32_t>(candidate);
      collector.add({here, flat->normal, flat->noise}, std::span(&member, 1));
    }
  }
  return std::move(collector).finish();
}

}  // namespace artcal::segmentation
