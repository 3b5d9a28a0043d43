#include "fitting/segmentation/spheres/find_spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "core/parallel.h"
#include "fitting/cloud.h"
#include "fitting/segmentation/spheres/candidate.h"
#include "fitting/segmentation/votes/centre_votes.h"
#include "fitting/segmentation/votes/vote_peaks.h"
#include "fitting/segmentation/votes/voxel_grid.h"

namespace artcal {
namespace {

using namespace segmentation;

constexpr std::size_t max_rejected = 200;
constexpr std::size_t max_candidates = 400;
constexpr int min_fine_votes = 8;
constexpr int min_coarse_votes = 5;

Expected<void> check(const Points& points, const SphereSearch& search) {
  for (const double radius : search.radii) {
    if (!(radius > 0.0) || !std::isfinite(radius)) {
      return wrong_usage(fmt::format("a sphere of radius {} mm cannot be looked for", radius));
    }
  }
  if (!(search.radius_tolerance > 0.0)) {
    return wrong_usage("the tolerance of the radius is not above zero");
  }
  if (points.cols() >= std::numeric_limits<std::int32_t>::max()) {
    return bad_input(fmt::format("{} points are more than can be looked at together (2^31)", points.cols()));
  }
  if (const Eigen::Index bad = fitting::first_not_finite(points); bad >= 0) {
    return bad_input(fmt::format("point {} is not a number; take such points out first", bad));
  }
  return {};
}

// Places worth a try: where patches of a quarter of the radius agree, and, for scans whose points are too far
// apart for these, patches of a half.
std::vector<Candidate> candidates(const VoxelGrid& grid, double radius) {
  std::vector<Candidate> places;
  const auto add = [&](const VoxelGrid& level, int fewest) {
    for (const VotePeak& peak : vote_peaks(centre_votes(level, radius), radius, fewest)) {
      const Eigen::Vector3d centre = grid.origin() + peak.centre;
      const bool known = std::any_of(places.begin(), places.end(), [&](const Candidate& place) {
        return (place.centre - centre).norm() < 0.3 * radius;
      });
      if (!known && places.size() < max_candidates) {
        places.push_back({centre, level.centroids_of(peak.cubes)});
      }
    }
  };
  add(grid, min_fine_votes);
  add(grid.coarsened(), min_coarse_votes);
  return places;
}

bool has_more_points(const FoundSphere& a, const FoundSphere& b) { return a.points.size() > b.points.size(); }

// Of those that stand in one place the one with most points stays.
void keep_best(std::vector<FoundSphere>& spheres, std::vector<RejectedSphere>& rejected) {
  std::stable_sort(spheres.begin(), spheres.end(), has_more_points);
  std::vector<FoundSphere> kept;
  for (auto& sphere : spheres) {
    const auto better = std::find_if(kept.begin(), kept.end(), [&](const FoundSphere& other) {
      const double apart = (other.fitted.feature.centre - sphere.fitted.feature.centre).norm();
      return apart <
             other.radius_wanted + sphere.radius_wanted - 0.1 * std::min(other.radius_wanted, sphere.radius_wanted);
    });
    if (better == kept.end()) {
      kept.push_back(std::move(sphere));
    } else if ((better->fitted.feature.centre - sphere.fitted.feature.centre).norm() > 0.1 * sphere.radius_wanted) {
      rejected.push_back(
          {sphere.fitted.feature, static_cast<int>(sphere.points.size()), RejectionReason::Overlaps,
           fmt::format("{} points that a sphere of radius {:.4g} mm would fit, but a better one of {} points stands "
                       "in the same place",
                       sphere.points.size(), sphere.radius_wanted, better->points.size())});
    }
  }
  spheres = std::move(kept);
}

// One sentence a place: what has been found there after all is not rejected, and what was tried twice is said once.
void tidy(std::vector<RejectedSphere>& rejected, const std::vector<FoundSphere>& spheres) {
  std::stable_sort(rejected.begin(), rejected.end(), [](const auto& a, const auto& b) { return a.points > b.points; });
  std::vector<RejectedSphere> kept;
  for (auto& one : rejected) {
    const auto stands_in = [&](const Sphere& other) {
      return (other.centre - one.sphere.centre).norm() < 0.5 * other.radius;
    };
    const bool known =
        std::any_of(spheres.begin(), spheres.end(),
                    [&](const FoundSphere& s) { return stands_in(s.fitted.feature); }) ||
        std::any_of(kept.begin(), kept.end(), [&](const RejectedSphere& k) { return stands_in(k.sphere); });
    if (!known && kept.size() < max_rejected) {
      kept.push_back(std::move(one));
    }
  }
  rejected = std::move(kept);
}

}  // namespace

Expected<SphereSearchResult> find_spheres(const Points& points, const SphereSearch& search) {
  if (auto checked = check(points, search); !checked) {
    return tl::unexpected(checked.error());
  }
  SphereSearchResult result;
  if (points.cols() == 0) {
    return result;
  }
  std::vector<double> radii = search.radii;
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  for (const double radius : radii) {
    const auto grid = VoxelGrid::make(points, 0.25 * radius);
    if (!grid) {
      return tl::unexpected(grid.error());
    }
    const std::vector<Candidate> places = candidates(*grid, radius);
    std::vector<std::optional<tl::expected<FoundSphere, RejectedSphere>>> examined(places.size());
    parallel_for(places.size(), 0,
                 [&](std::size_t i) { examined[i] = examine(points, *grid, places[i], radius, search); });
    for (auto& found : examined) {
      if (*found) {
        result.spheres.push_back(std::move(**found));
      } else {
        result.rejected.push_back(std::move(found->error()));
      }
    }
  }
  keep_best(result.spheres, result.rejected);
  tidy(result.rejected, result.spheres);
  return result;
}

}  // namespace artcal
