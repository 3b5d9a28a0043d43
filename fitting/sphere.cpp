#include "fitting/estimate.h"
#include "fitting/round_models.h"

#include <fmt/format.h>

namespace artcal::fitting {
namespace {

// Curvature zero, on the points' plane, would be a start for a patch; a whole ball needs its centre. The
// linear fit |p|² = 2·c·p + t serves both: exact for exact points, and good enough else.
RoundState start_sphere(const Cloud& cloud) {
  RowReducer<5> reducer;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.points.col(i);
    Eigen::Matrix<double, 1, 5> row;
    row << 2.0 * p.transpose(), 1.0, p.squaredNorm();
    reducer.add(cloud.root_weight(i) * row);
  }
  const auto triangle = reducer.triangle();
  const Eigen::Vector4d solved =
      triangle.topLeftCorner<4, 4>().colPivHouseholderQr().solve(triangle.topRightCorner<4, 1>());
  const Eigen::Vector3d centre = solved.head<3>();
  const double radius = std::sqrt(std::max(solved(3) + centre.squaredNorm(), 1e-4));
  RoundState state;
  const double off = centre.norm();
  const Eigen::Vector3d normal = off > 1e-3 * radius ? Eigen::Vector3d(-centre / off) : cloud.axes.col(2);
  state.frame.col(0) = normal;
  state.frame.col(1) = normal.unitOrthogonal();
  state.frame.col(2) = normal.cross(state.frame.col(1));
  state.point = centre + radius * normal;
  state.curvature = 1.0 / radius;
  return state;
}

// The same start, its radius replaced: the surface stays at the points, on the side where they curve.
RoundState with_radius(RoundState state, double radius) {
  state.curvature = 1.0 / radius;
  return state;
}

Sphere sphere_of(const RoundState& state) {
  return {state.point - state.frame.col(0) / state.curvature, std::abs(1.0 / state.curvature)};
}

template <bool FixedRadius>
Expected<Estimate<Sphere>> solve(const Cloud& cloud, const FitOptions& options, const RoundState& start) {
  const SphereModel<FixedRadius> model{cloud};
  const auto solution = minimise(model, start, 200);
  auto [estimate, unit] = estimate_of(model, solution, static_cast<int>(cloud.size()), options, sphere_of);
  const double noise = noise_or_rounding(cloud, estimate.noise);
  if (!unit) {
    return no_solution(
        "the points do not tell a sphere: they lie on one circle, which many spheres hold; "
        "probe points out of its plane");
  }
  // Two standard deviations wider than the value itself: any radius from here to infinity would do.
  const double radius = estimate.feature.radius;
  const double doubt = noise * std::sqrt(unit->diagonal().maxCoeff());
  if (!(doubt < 0.5 * radius)) {
    return no_solution(
        fmt::format("the points cover too small a patch to tell the sphere: radius {:.4g} mm comes out "
                    "with a standard uncertainty of {:.2g} mm; probe more of it or give the radius",
                    radius * cloud.scale, doubt * cloud.scale));
  }
  return estimate;
}

}  // namespace

Expected<Estimate<Sphere>> least_squares_sphere(const Cloud& cloud, const FitOptions& options) {
  const RoundState start = start_sphere(cloud);
  if (options.fixed_radius) {
    return solve<true>(cloud, options, with_radius(start, *options.fixed_radius / cloud.scale));
  }
  return solve<false>(cloud, options, start);
}

}  // namespace artcal::fitting
