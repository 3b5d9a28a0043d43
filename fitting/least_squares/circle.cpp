#include "fitting/least_squares/estimate.h"
#include "fitting/least_squares/round_models.h"

#include <fmt/format.h>

namespace artcal::fitting {
namespace {

// In the plane of the widest two directions, the linear fit x² + y² = 2·c·(x, y) + t.
RoundState start_circle(const Cloud& cloud) {
  RowReducer<4> reducer;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector2d p = cloud.axes.leftCols<2>().transpose() * cloud.points.col(i);
    reducer.add(cloud.root_weight(i) * Eigen::RowVector4d(2.0 * p.x(), 2.0 * p.y(), 1.0, p.squaredNorm()));
  }
  const auto triangle = reducer.triangle();
  const Eigen::Vector3d solved =
      triangle.topLeftCorner<3, 3>().colPivHouseholderQr().solve(triangle.topRightCorner<3, 1>());
  const double radius = std::sqrt(std::max(solved(2) + solved.head<2>().squaredNorm(), 1e-4));
  const Eigen::Vector3d centre = cloud.axes.leftCols<2>() * solved.head<2>();
  const double off = centre.norm();
  RoundState state;
  state.frame.col(0) = off > 1e-3 * radius ? Eigen::Vector3d(-centre / off) : cloud.axes.col(0);
  state.frame.col(2) = cloud.axes.col(2);
  state.frame.col(1) = state.frame.col(2).cross(state.frame.col(0));
  state.point = centre + radius * state.frame.col(0);
  state.curvature = 1.0 / radius;
  return state;
}

Circle circle_of(const RoundState& state) {
  return {state.point - state.frame.col(0) / state.curvature, state.frame.col(2), std::abs(1.0 / state.curvature)};
}

Expected<void> judge(const Cloud& cloud, const Estimate<Circle>& estimate,
                     const std::optional<Covariance<Circle>>& unit) {
  const double noise = noise_or_rounding(cloud, estimate.noise);
  const double doubt = unit ? noise * std::sqrt((*unit)(6, 6)) : 0.0;
  const double radius = estimate.feature.radius;
  if (!unit || !(doubt < 0.5 * radius)) {
    return no_solution(
        fmt::format("the points do not determine a circle: on so short an arc they may as well lie on one "
                    "line (radius {:.4g} ± {:.2g} mm); probe more of it",
                    radius * cloud.scale, doubt * cloud.scale));
  }
  return {};
}

// What the plane's own doubt adds: the centre lies in the plane and tilts with it.
Covariance<Circle> plane_part(const Circle& circle, const Covariance<Plane>& plane) {
  Eigen::Matrix<double, 7, 6> by_plane = Eigen::Matrix<double, 7, 6>::Zero();
  by_plane.topLeftCorner<3, 3>().setIdentity();
  by_plane.topRightCorner<3, 3>() = -circle.normal * circle.centre.transpose();
  by_plane.block<3, 3>(3, 3).setIdentity();
  return by_plane * plane * by_plane.transpose();
}

// A known normal has no uncertainty; the height of the circle is that of the points' centroid.
Covariance<Plane> known_plane(const Cloud& cloud, double noise) {
  Covariance<Plane> plane = Covariance<Plane>::Zero();
  const Eigen::Vector3d& normal = cloud.axes.col(2);
  plane.topLeftCorner<3, 3>() = noise * noise / cloud.total_weight() * normal * normal.transpose();
  return plane;
}

Expected<std::optional<Covariance<Plane>>> plane_of(const Cloud& cloud, const FitOptions& options) {
  if (options.circle_normal) {
    return std::nullopt;
  }
  return least_squares_plane(cloud, options).map([](const Estimate<Plane>& plane) { return plane.covariance; });
}

Expected<Estimate<Circle>> projected(const Cloud& cloud, const FitOptions& options) {
  const auto plane = plane_of(cloud, options);
  if (!plane) {
    return tl::unexpected(plane.error());
  }
  const CircleModel<false> model{cloud};
  const auto solution = minimise(model, start_circle(cloud), 200);
  auto [estimate, unit] = estimate_of(model, solution, static_cast<int>(cloud.size()), options, circle_of);
  if (const auto sound = judge(cloud, estimate, unit); !sound) {
    return tl::unexpected(sound.error());
  }
  if (estimate.covariance && options.circle_normal) {
    *estimate.covariance += plane_part(estimate.feature, known_plane(cloud, *estimate.noise));
  } else if (estimate.covariance && *plane) {
    *estimate.covariance += plane_part(estimate.feature, **plane);
  }
  return estimate;
}

Expected<Estimate<Circle>> spatial(const Cloud& cloud, const FitOptions& options) {
  if (const auto plane = least_squares_plane(cloud, options); !plane) {
    return tl::unexpected(plane.error());
  }
  const CircleModel<true> model{cloud};
  const auto solution = minimise(model, start_circle(cloud), 200);
  auto [estimate, unit] = estimate_of(model, solution, 2 * static_cast<int>(cloud.size()), options, circle_of);
  if (const auto sound = judge(cloud, estimate, unit); !sound) {
    return tl::unexpected(sound.error());
  }
  return estimate;
}

}  // namespace

Expected<Estimate<Circle>> least_squares_circle(const Cloud& cloud, const FitOptions& options) {
  return options.circle == CircleConvention::Projected ? projected(cloud, options) : spatial(cloud, options);
}

}  // namespace artcal::fitting
