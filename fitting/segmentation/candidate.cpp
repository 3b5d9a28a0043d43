#include "fitting/segmentation/candidate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fitting/segmentation/surface_points.h"

namespace artcal::segmentation {
namespace {

constexpr int fewest_points = 10;
constexpr double least_coverage = 0.03;      // a cap of 20 degrees around its pole
constexpr double most_noise = 0.04;          // of the radius
constexpr double most_out_of_round = 0.004;  // of the radius: no ball is that far from round
constexpr double least_share = 0.3;          // of the points next to the surface

std::string at(const Eigen::Vector3d& p) { return fmt::format("({:.1f}, {:.1f}, {:.1f})", p.x(), p.y(), p.z()); }

Eigen::Matrix3Xd columns(const Points& points, const std::vector<int>& which, const Eigen::Vector3d& origin) {
  Eigen::Matrix3Xd some(3, static_cast<Eigen::Index>(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i) {
    some.col(static_cast<Eigen::Index>(i)) = points.col(which[i]) - origin;
  }
  return some;
}

struct Trial {
  const Points& points;
  double radius;
  const SphereSearch& search;

  tl::unexpected<RejectedSphere> rejected(const Eigen::Vector3d& centre, int count, RejectionReason reason,
                                          std::string why) const {
    return tl::unexpected(RejectedSphere{{centre, radius}, count, reason, std::move(why)});
  }
};

// What the points near the surface say against a sphere, before anything is fitted to the last digit.
std::optional<tl::unexpected<RejectedSphere>> objection(const Trial& trial, const Surface& surface,
                                                        const Eigen::Vector3d& centre, int next_to_it) {
  const double radius = trial.radius;
  const int count = surface.count;
  if (count < fewest_points) {
    return trial.rejected(centre, count, RejectionReason::TooFewPoints,
                          fmt::format("{} points on a sphere of radius {:.4g} mm about {}, at least {} are needed",
                                      count, radius, at(centre), fewest_points));
  }
  if (surface.settled.noise > most_noise * radius) {
    return trial.rejected(centre, count, RejectionReason::NotASphere,
                          fmt::format("points near {} scatter by {:.2g} mm about a sphere of radius {:.4g} mm",
                                      at(centre), surface.settled.noise, radius));
  }
  if (count < least_share * next_to_it) {
    return trial.rejected(centre, count, RejectionReason::NotASphere,
                          fmt::format("only {} of {} points next to a sphere of radius {:.4g} mm about {} lie on it: "
                                      "another surface that touches it (stem, edge, table)",
                                      count, next_to_it, radius, at(centre)));
  }
  if (surface.coverage < least_coverage) {
    return trial.rejected(
        centre, count, RejectionReason::TooLittleSeen,
        fmt::format("{} points about {} show {:.1f} % of a sphere of radius {:.4g} mm, at least {:.0f} % "
                    "are needed to call it one",
                    count, at(centre), 100.0 * surface.coverage, radius, 100.0 * least_coverage));
  }
  return std::nullopt;
}

// Cubes in place of points, a few hundred where there may be a million: enough to see what is no sphere at all.
std::optional<Eigen::Vector3d> rough_place(const VoxelGrid& grid, const Eigen::Vector3d& vote, double radius) {
  const auto settled = settle(grid.centroids_within(vote, 1.6 * radius), vote, radius, 0.25 * radius);
  const bool is_round = settled && settled->noise < 2.0 * most_noise * radius;
  return is_round ? std::optional(settled->centre) : std::nullopt;
}

}  // namespace

std::optional<tl::expected<FoundSphere, RejectedSphere>> examine(const Points& points, const VoxelGrid& grid,
                                                                 const Eigen::Vector3d& vote, double radius,
                                                                 const SphereSearch& search) {
  const Trial trial{points, radius, search};
  const auto place = rough_place(grid, vote, radius);
  if (!place) {
    return std::nullopt;
  }
  const Eigen::Vector3d centre = *place;
  const std::vector<int> around = grid.within(points, centre, 1.6 * radius);
  const Eigen::Matrix3Xd local = columns(points, around, centre);
  const auto settled = settle(local, Eigen::Vector3d::Zero(), radius, 0.1 * radius);
  if (!settled) {
    return std::nullopt;
  }
  const Surface surface = own_surface(local, *settled, radius);
  const Eigen::Vector3d middle = centre + surface.settled.centre;
  const auto next_to_it = static_cast<int>(
      (((local.colwise() - surface.settled.centre).colwise().norm().array() - radius).abs() < 0.2 * radius).count());
  if (auto no = objection(trial, surface, middle, next_to_it)) {
    return *no;
  }
  FoundSphere found;
  found.radius_wanted = radius;
  found.coverage = surface.coverage;
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (surface.is_own[i] != 0) {
      found.points.push_back(around[i]);
    }
  }
  found.left_out = next_to_it - surface.count;
  const Eigen::Matrix3Xd own = columns(points, found.points, Eigen::Vector3d::Zero());
  const auto free = fit<Sphere>(own);
  if (free) {
    found.seen_radius = free->feature.radius;
    found.u_seen_radius = free->covariance ? std::sqrt(std::max(0.0, (*free->covariance)(3, 3))) : 0.0;
    const double allowed = search.radius_tolerance * radius + search.distortion + 4.0 * found.u_seen_radius;
    if (std::abs(found.seen_radius - radius) > allowed) {
      const Trial seen{points, found.seen_radius, search};
      return seen.rejected(free->feature.centre, surface.count, RejectionReason::WrongRadius,
                           fmt::format("a sphere of radius {:.4g} mm at {}, wanted is {:.4g} mm", found.seen_radius,
                                       at(free->feature.centre), radius));
    }
  }
  if (const double leaves = out_of_round(local, surface, radius);
      leaves > most_out_of_round * radius + search.distortion) {
    return trial.rejected(
        middle, surface.count, RejectionReason::NotASphere,
        fmt::format("the surface about {} leaves a sphere of radius {:.4g} mm by {:.2g} mm from place to "
                    "place: something else that is round (stem, cylinder, cone)",
                    at(middle), radius, leaves));
  }
  FitOptions options;
  if (search.fixed_radius) {
    options.fixed_radius = radius;
  }
  auto fitted = fit<Sphere>(own, options);
  if (!fitted) {
    return trial.rejected(middle, surface.count, RejectionReason::NotASphere, fitted.error().message);
  }
  found.fitted = std::move(*fitted);
  return found;
}

}  // namespace artcal::segmentation
