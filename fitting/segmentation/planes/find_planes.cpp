#include "fitting/segmentation/planes/find_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fitting/bounding_box.h"
#include "fitting/chosen_points.h"
#include "fitting/cloud.h"
#include "fitting/segmentation/planes/curved.h"
#include "fitting/segmentation/planes/flat_patches.h"
#include "fitting/segmentation/planes/propose_plane.h"
#include "fitting/segmentation/votes/voxel_grid.h"

namespace artcal {
namespace {

using namespace segmentation;

constexpr std::size_t min_plane_points = 20;
constexpr std::size_t max_neighbourhoods = 3000;  // of points: their time goes with the square

/// One search for planes: the points, those that belong to something by now, and the planes found.
class PlaneFinder {
 public:
  PlaneFinder(const Points& points, const PlaneSearch& search)
      : points_(points), search_(search), taken_(static_cast<std::size_t>(points.cols()), 0) {
    for (const int i : search.taken) {
      taken_[static_cast<std::size_t>(i)] = 1;
    }
    const double largest = fitting::bounding_box(points).largest_coordinate();
    rounding_ = 16.0 * std::numeric_limits<double>::epsilon() * largest;
  }

  [[nodiscard]] bool is_done() const { return static_cast<int>(planes_.size()) >= search_.count; }
  [[nodiscard]] std::vector<int> untaken() const {
    std::vector<int> columns;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      if (taken_[i] == 0) {
        columns.push_back(static_cast<int>(i));
      }
    }
    return columns;
  }
  [[nodiscard]] std::vector<FoundPlane> planes() && { return std::move(planes_); }

  void look_at(const FlatPatches& flat, double patch_size) {
    std::vector<char> used(flat.size(), 0);
    // The proposals come from floats about the patches' middle; what those round is no deviation from a plane.
    const double reach = flat.centroids.cols() == 0
                             ? 0.0
                             : (flat.centroids.colwise() - flat.centroids.rowwise().mean()).cwiseAbs().maxCoeff();
    const double float_rounding = 8.0 * reach * static_cast<double>(std::numeric_limits<float>::epsilon());
    const double proposal = std::max({3.0 * flat.noise, 1e-6 * patch_size, float_rounding});
    const int max_tries = 4 * search_.count + 8;
    for (int tries = 0; tries < max_tries && !is_done(); ++tries) {
      const auto proposed = propose_plane(flat.centroids, used, proposal);
      if (!proposed) {
        break;
      }
      auto found = converged_plane(flat, *proposed, 2.0 * proposal);
      if (found && is_part_of_another(*found)) {
        found.reset();
      }
      const Plane plane = found ? found->fitted.feature : *proposed;
      const double width = found ? std::max(4.0 * found->fitted.rms, proposal) : proposal;
      for (std::size_t k = 0; k < used.size(); ++k) {
        const bool here = std::abs(signed_distance(plane, flat.centroids.col(static_cast<Eigen::Index>(k)))) <= width;
        used[k] = here ? 1 : used[k];
      }
      if (found) {
        for (const int i : found->points) {
          taken_[static_cast<std::size_t>(i)] = 1;
        }
        planes_.push_back(std::move(*found));
      }
    }
  }

 private:
  // What the search for planes left of them, at their borders or in their noise, is no other one, whichever way the
  // strays of several lie.
  [[nodiscard]] bool is_part_of_another(const FoundPlane& found) const {
    constexpr double limit = 6.0;  // standard deviations
    const auto strays = std::count_if(found.points.begin(), found.points.end(), [&](int i) {
      return std::any_of(planes_.begin(), planes_.end(), [&](const FoundPlane& other) {
        return std::abs(signed_distance(other.fitted.feature, points_.col(i))) <
               std::max(limit * other.fitted.rms, rounding_);
      });
    });
    return 2 * strays > static_cast<std::ptrdiff_t>(found.points.size());
  }

  // Points of patches that lie along the plane, and in it themselves.
  [[nodiscard]] std::vector<int> points_in(const FlatPatches& flat, const Plane& plane, double width) const {
    std::vector<int> own;
    for (std::size_t k = 0; k < flat.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      // A tenth of a radian: the normal of a few noisy points is not known better.
      if (std::abs(signed_distance(plane, flat.centroids.col(column))) < width &&
          std::abs(plane.normal.dot(flat.normals.col(column))) > 0.995) {
        for (const std::uint32_t i : flat.points_of(k)) {
          if (taken_[i] == 0 && std::abs(signed_distance(plane, points_.col(i))) < width) {
            own.push_back(static_cast<int>(i));
          }
        }
      }
    }
    std::sort(own.begin(), own.end());
    return own;
  }

  [[nodiscard]] std::optional<FoundPlane> converged_plane(const FlatPatches& flat, Plane plane, double width) const {
    constexpr int max_rounds = 10;
    FoundPlane found;
    for (int round = 0; round < max_rounds; ++round) {
      auto own = points_in(flat, plane, width);
      if (own.size() < min_plane_points) {
        return std::nullopt;
      }
      if (own == found.points) {
        break;
      }
      auto fitted = fit<Plane>(fitting::chosen_points(points_, own));
      if (!fitted) {
        return std::nullopt;
      }
      plane = fitted->feature;
      width = std::max(4.0 * fitted->rms, rounding_);
      found = {std::move(*fitted), std::move(own)};
    }
    if (is_curved(fitting::chosen_points(points_, found.points), plane)) {
      return std::nullopt;
    }
    return found;
  }

  const Points& points_;
  const PlaneSearch& search_;
  std::vector<char> taken_;
  std::vector<FoundPlane> planes_;
  double rounding_ = 0.0;  // mm, of a distance
};

}  // namespace

Expected<std::vector<FoundPlane>> find_planes(const Points& points, const PlaneSearch& search) {
  if (points.cols() == 0 || search.count <= 0) {
    return std::vector<FoundPlane>();
  }
  if (const Eigen::Index bad = fitting::first_not_finite(points); bad >= 0) {
    return bad_input("a point is not a number; take such points out first");
  }
  PlaneFinder finder(points, search);
  // Larger cubes for planes of which the scan has fewer points than of the rest.
  constexpr int max_sizes = 4;
  double edge = search.patch;
  for (int size = 0; size < max_sizes && !finder.is_done(); ++size, edge *= 2.0) {
    const auto grid = VoxelGrid::make(points, edge);
    if (!grid) {
      return tl::unexpected(grid.error());
    }
    finder.look_at(flat_cubes(*grid), edge);
  }
  for (const int neighbours : {12, 30}) {
    const auto left = finder.untaken();
    if (!finder.is_done() && left.size() >= min_plane_points && left.size() <= max_neighbourhoods) {
      finder.look_at(flat_neighbourhoods(points, left, neighbours), edge);
    }
  }
  auto planes = std::move(finder).planes();
  std::stable_sort(planes.begin(), planes.end(),
                   [](const FoundPlane& a, const FoundPlane& b) { return a.points.size() > b.points.size(); });
  return planes;
}

}  // namespace artcal
