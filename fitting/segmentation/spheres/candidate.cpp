#include "fitting/segmentation/spheres/candidate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/point_text.h"
#include "fitting/segmentation/spheres/other_shape.h"
#include "fitting/segmentation/spheres/out_of_round.h"
#include "fitting/segmentation/spheres/own_surface.h"
#include "fitting/segmentation/spheres/sphere_surface_fit.h"

namespace artcal::segmentation {
namespace {

constexpr int min_ball_points = 10;
constexpr double least_coverage = 0.03;     // a cap of 20 degrees around its pole
constexpr double least_extent = 0.1;        // of the radius: rms of the points across their narrowest band
constexpr double max_noise = 0.04;          // of the radius
constexpr double max_out_of_round = 0.004;  // of the radius: no ball is that far from round
constexpr double least_share = 0.3;         // of the points next to the surface

std::string at(const Eigen::Vector3d& p, double radius) { return point_text(p, 0.01 * radius); }

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
  if (count < min_ball_points) {
    return trial.rejected(centre, count, RejectionReason::TooFewPoints,
                          fmt::format("{} points on a sphere of radius {:.4g} mm about {}, at least {} are needed",
                                      count, radius, at(centre, radius), min_ball_points));
  }
  if (surface.sphere.noise > max_noise * radius) {
    return trial.rejected(centre, count, RejectionReason::NotASphere,
                          fmt::format("points near {} scatter by {:.2g} mm about a sphere of radius {:.4g} mm",
                                      at(centre, radius), surface.sphere.noise, radius));
  }
  if (count < least_share * next_to_it) {
    return trial.rejected(centre, count, RejectionReason::NotASphere,
                          fmt::format("only {} of {} points next to a sphere of radius {:.4g} mm about {} lie on it: "
                                      "another surface that touches it (stem, edge, table)",
                                      count, next_to_it, radius, at(centre, radius)));
  }
  if (surface.narrowest < least_extent) {
    return trial.rejected(
        centre, count, RejectionReason::TooLittleSeen,
        fmt::format("{} points about {} lie on a band of a sphere of radius {:.4g} mm, {:.2g} mm wide in "
                    "standard deviation: too narrow to determine its centre",
                    count, at(centre, radius), radius, surface.narrowest * radius));
  }
  if (surface.coverage < least_coverage) {
    return trial.rejected(
        centre, count, RejectionReason::TooLittleSeen,
        fmt::format("{} points about {} show {:.1f} % of a sphere of radius {:.4g} mm, at least {:.0f} % "
                    "are needed to call it one",
                    count, at(centre, radius), 100.0 * surface.coverage, radius, 100.0 * least_coverage));
  }
  return std::nullopt;
}

// From the vote to the surface next to it. The cubes that voted are few and lie on the surface, however many others a
// dense scan fills with mixed pixels.
std::optional<SphereFit> rough_place(const Candidate& candidate, double radius) {
  return fit_to_surface(candidate.surface, candidate.centre, radius, 0.25 * radius);
}

}  // namespace

tl::expected<FoundSphere, RejectedSphere> examine(const Points& points, const VoxelGrid& grid,
                                                  const Candidate& candidate, double radius,
                                                  const SphereSearch& search) {
  const Trial trial{points, radius, search};
  const auto rough = rough_place(candidate, radius);
  if (!rough || rough->noise > 2.0 * max_noise * radius) {
    return trial.rejected(
        candidate.centre, static_cast<int>(candidate.surface.cols()), RejectionReason::NotASphere,
        fmt::format("pieces of surface about {} are curved as a sphere of radius {:.4g} mm, but lie on "
                    "none together",
                    at(candidate.centre, radius), radius));
  }
  const Eigen::Vector3d centre = rough->centre;
  const std::vector<int> around = grid.within(points, centre, 1.6 * radius);
  const Eigen::Matrix3Xd local = columns(points, around, centre);
  const auto sphere = fit_to_surface(local, Eigen::Vector3d::Zero(), radius, 0.1 * radius);
  if (!sphere) {
    return trial.rejected(centre, static_cast<int>(candidate.surface.cols()), RejectionReason::NotASphere,
                          fmt::format("the points about {} do not determine the centre of a sphere of radius {:.4g} mm",
                                      at(centre, radius), radius));
  }
  const Surface surface = own_surface(local, *sphere, radius);
  const Eigen::Vector3d middle = centre + surface.sphere.centre;
  const auto next_to_it = static_cast<int>(
      (((local.colwise() - surface.sphere.centre).colwise().norm().array() - radius).abs() < 0.2 * radius).count());
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
  if (!free) {
    return trial.rejected(
        middle, surface.count, RejectionReason::NotASphere,
        fmt::format("{} points about {} lie near a sphere of radius {:.4g} mm, but determine none: {}", surface.count,
                    at(middle, radius), radius, free.error().message));
  }
  found.seen_radius = free->feature.radius;
  found.u_seen_radius = free->covariance ? std::sqrt(std::max(0.0, (*free->covariance)(3, 3))) : 0.0;
  const double allowed = search.radius_tolerance * radius + search.distortion + 4.0 * found.u_seen_radius;
  if (std::abs(found.seen_radius - radius) > allowed) {
    const Trial seen{points, found.seen_radius, search};
    return seen.rejected(free->feature.centre, surface.count, RejectionReason::WrongRadius,
                         fmt::format("a sphere of radius {:.4g} mm at {}, wanted is {:.4g} mm", found.seen_radius,
                                     at(free->feature.centre, radius), radius));
  }
  if (const double leaves = out_of_round(local, surface, radius);
      leaves > max_out_of_round * radius + search.distortion) {
    return trial.rejected(
        middle, surface.count, RejectionReason::NotASphere,
        fmt::format("the surface about {} leaves a sphere of radius {:.4g} mm by {:.2g} mm from place to "
                    "place: something else that is round (stem, cylinder, cone)",
                    at(middle, radius), radius, leaves));
  }
  if (const auto other = other_shape(own)) {
    return trial.rejected(middle, surface.count, RejectionReason::NotASphere,
                          fmt::format("{} points about {} lie on a {} as well as on a sphere of radius {:.4g} mm",
                                      surface.count, at(middle, radius), *other, radius));
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
