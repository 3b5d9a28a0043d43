#include "fitting/segmentation/find_planes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>

#include "fitting/cloud.h"
#include "fitting/segmentation/propose_plane.h"
#include "fitting/segmentation/voxel_grid.h"

namespace artcal {
namespace {

using namespace segmentation;

constexpr double fewest_in_cube = 5.0;
constexpr std::size_t fewest_points = 30;

// The cubes that hold a piece of something flat.
struct FlatCubes {
  std::vector<std::size_t> cubes;
  Eigen::Matrix3Xd centroids;  // mm
  Eigen::Matrix3Xd normals;
  double noise = 0.0;  // median standard deviation across them
};

FlatCubes flat_cubes(const VoxelGrid& grid) {
  FlatCubes flat;
  std::vector<double> noises;
  std::vector<Eigen::Vector3d> centroids, normals;
  for (std::size_t cube = 0; cube < grid.size(); ++cube) {
    const Moments& moments = grid.moments(cube);
    if (moments.count < fewest_in_cube) {
      continue;
    }
    const Eigen::Vector3d mean = moments.sum / moments.count;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(moments.squares / moments.count - mean * mean.transpose());
    const Eigen::Vector3d& variances = eigen.eigenvalues();
    if (variances(0) < 0.05 * variances(1) && variances(1) > 0.03 * variances(2)) {
      flat.cubes.push_back(cube);
      centroids.emplace_back(grid.origin() + mean);
      normals.emplace_back(eigen.eigenvectors().col(0));
      noises.push_back(std::sqrt(std::max(0.0, variances(0)) * moments.count / (moments.count - 3.0)));
    }
  }
  const auto columns = [](const std::vector<Eigen::Vector3d>& vectors) {
    return Eigen::Matrix3Xd::Map(vectors.empty() ? nullptr : vectors.front().data(), 3,
                                 static_cast<Eigen::Index>(vectors.size()));
  };
  flat.centroids = columns(centroids);
  flat.normals = columns(normals);
  if (!noises.empty()) {
    const auto middle = noises.begin() + static_cast<std::ptrdiff_t>(noises.size() / 2);
    std::nth_element(noises.begin(), middle, noises.end());
    flat.noise = *middle;
  }
  return flat;
}

Eigen::Matrix3Xd columns(const Points& points, const std::vector<int>& which) {
  Eigen::Matrix3Xd some(3, static_cast<Eigen::Index>(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i) {
    some.col(static_cast<Eigen::Index>(i)) = points.col(which[i]);
  }
  return some;
}

// Points of cubes that lie along the plane, and in it themselves.
std::vector<int> points_in(const Points& points, const VoxelGrid& grid, const FlatCubes& flat, const Plane& plane,
                           double width, const std::vector<char>& taken) {
  std::vector<int> own;
  for (std::size_t k = 0; k < flat.cubes.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    // A tenth of a radian: the normal of a few noisy points is not known better.
    if (std::abs(signed_distance(plane, flat.centroids.col(column))) < width &&
        std::abs(plane.normal.dot(flat.normals.col(column))) > 0.995) {
      for (const std::uint32_t i : grid.points_in(flat.cubes[k])) {
        if (taken[i] == 0 && std::abs(signed_distance(plane, points.col(i))) < width) {
          own.push_back(static_cast<int>(i));
        }
      }
    }
  }
  std::sort(own.begin(), own.end());
  return own;
}

std::optional<FoundPlane> settled(const Points& points, const VoxelGrid& grid, const FlatCubes& flat, Plane plane,
                                  const std::vector<char>& taken) {
  constexpr int most_rounds = 10;
  double width = std::max(6.0 * flat.noise, 1e-9 * grid.edge());
  FoundPlane found;
  for (int round = 0; round < most_rounds; ++round) {
    auto own = points_in(points, grid, flat, plane, width, taken);
    if (own.size() < fewest_points) {
      return std::nullopt;
    }
    if (own == found.points) {
      break;
    }
    auto fitted = fit<Plane>(columns(points, own));
    if (!fitted) {
      return std::nullopt;
    }
    plane = fitted->feature;
    width = std::max(4.0 * fitted->rms, 1e-9 * grid.edge());
    found = {std::move(*fitted), std::move(own)};
  }
  return found;
}

}  // namespace

Expected<std::vector<FoundPlane>> find_planes(const Points& points, const PlaneSearch& search) {
  std::vector<FoundPlane> planes;
  if (points.cols() == 0 || search.count <= 0) {
    return planes;
  }
  if (const Eigen::Index bad = fitting::first_not_finite(points); bad >= 0) {
    return bad_input("a point is not a number; take such points out first");
  }
  const auto grid = VoxelGrid::make(points, search.patch);
  if (!grid) {
    return tl::unexpected(grid.error());
  }
  std::vector<char> taken(static_cast<std::size_t>(points.cols()), 0);
  for (const int i : search.taken) {
    taken[i] = 1;
  }
  FlatCubes flat = flat_cubes(*grid);
  std::vector<char> used(flat.cubes.size(), 0);
  const int most_tries = 4 * search.count + 8;
  for (int tries = 0; tries < most_tries && static_cast<int>(planes.size()) < search.count; ++tries) {
    const auto proposed = propose_plane(flat.centroids, used, std::max(3.0 * flat.noise, 1e-6 * grid->edge()));
    if (!proposed) {
      break;
    }
    auto found = settled(points, *grid, flat, *proposed, taken);
    const Plane plane = found ? found->fitted.feature : *proposed;
    const double width = found ? std::max(4.0 * found->fitted.rms, 3.0 * flat.noise) : 3.0 * flat.noise;
    for (std::size_t k = 0; k < used.size(); ++k) {
      const bool here = std::abs(signed_distance(plane, flat.centroids.col(static_cast<Eigen::Index>(k)))) <= width;
      used[k] = here ? 1 : used[k];
    }
    if (found) {
      for (const int i : found->points) {
        taken[i] = 1;
      }
      planes.push_back(std::move(*found));
    }
  }
  std::stable_sort(planes.begin(), planes.end(),
                   [](const FoundPlane& a, const FoundPlane& b) { return a.points.size() > b.points.size(); });
  return planes;
}

}  // namespace artcal
