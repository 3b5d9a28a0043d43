#include <utility>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "fitting/least_squares/estimate.h"
#include "fitting/least_squares/round_models.h"

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

// The same start with its radius replaced, the surface bulging to one side or the other of the points.
RoundState with_radius(RoundState state, double radius, double side) {
  state.curvature = 1.0 / radius;
  state.frame.col(0) *= side;
  state.frame.col(2) *= side;
  return state;
}

Sphere sphere_of(const RoundState& state) {
  return {state.point - state.frame.col(0) / state.curvature, std::abs(1.0 / state.curvature)};
}

// In what the points tell least, v = (v_c, v_r), their directions û have to differ by more than the noise
// makes of them: on one circle û·v_c + v_r is nothing but noise, and a slope through it looks determined.
bool on_one_circle(const Cloud& cloud, const Sphere& sphere, double noise) {
  Eigen::Matrix4Xd rows(4, cloud.size());
  rows.topRows<3>() = (cloud.points.colwise() - sphere.centre).colwise().normalized();
  rows.row(3).setOnes();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(rows * rows.transpose());
  const Eigen::Vector4d v = eigen.eigenvectors().col(0);
  const double told = (v.transpose() * rows).squaredNorm();
  const Eigen::RowVectorXd along = v.head<3>().transpose() * rows.topRows<3>();
  const double across = static_cast<double>(cloud.size()) * v.head<3>().squaredNorm() - along.squaredNorm();
  constexpr double sure = 3.0;
  return told < std::pow(sure * noise / sphere.radius, 2) * across;
}

Expected<Estimate<Sphere>> judged(const Cloud& cloud, const Estimate<Sphere>& estimate,
                                  const std::optional<Covariance<Sphere>>& unit) {
  const double noise = noise_or_rounding(cloud, estimate.noise);
  const double radius = estimate.feature.radius;
  const double doubt = unit ? noise * std::sqrt(unit->diagonal().maxCoeff()) : 0.0;
  // Two standard deviations wider than the value itself: any radius from here to infinity would do.
  if (unit && !(doubt < 0.5 * radius)) {
    return no_solution(
        fmt::format("the points cover too small a patch to determine the sphere: radius {:.4g} mm comes out "
                    "with a standard uncertainty of {:.2g} mm; probe more of it or give the radius",
                    radius * cloud.scale, doubt * cloud.scale));
  }
  return estimate;
}

Expected<Estimate<Sphere>> free_sphere(const Cloud& cloud, const FitOptions& options) {
  const SphereModel<false> model{cloud};
  const auto solution = minimise(model, start_sphere(cloud), 200);
  const auto [estimate, unit] = estimate_of(model, solution, static_cast<int>(cloud.size()), options, sphere_of);
  const double noise = estimate.noise.value_or(0.0);
  if (!unit || on_one_circle(cloud, estimate.feature, noise)) {
    return no_solution(
        scatter_hides("sphere", cloud, noise, estimate.feature.radius)
            .value_or(fmt::format("the points do not determine a sphere: they lie on one circle in one plane{}, "
                                  "which many spheres hold; probe points out of that plane",
                                  as_noise_shows(cloud, noise))));
  }
  return judged(cloud, estimate, unit);
}

// A patch of a ball of known size fits from both sides of it, exactly so where it lies in one plane.
Expected<Estimate<Sphere>> sphere_of_radius(const Cloud& cloud, const FitOptions& options, double radius) {
  const SphereModel<true> model{cloud};
  const RoundState start = start_sphere(cloud);
  auto best = minimise(model, with_radius(start, radius, 1.0), 200);
  auto other = minimise(model, with_radius(start, radius, -1.0), 200);
  const bool elsewhere = (sphere_of(best.state).centre - sphere_of(other.state).centre).norm() > 1e-6;
  const double freedom = std::max(1.0, static_cast<double>(cloud.size() - 3));
  const double least = std::max(std::min(best.cost, other.cost) / freedom, cloud.rounding * cloud.rounding);
  const bool alike = elsewhere && std::abs(best.cost - other.cost) < 9.0 * least;
  if (alike && !options.towards) {
    return no_solution(
        "two spheres of this radius hold the points, one on either side of their plane; probe points out of "
        "that plane or give the direction towards the probe");
  }
  const auto behind = [&](const RoundState& state) { return sphere_of(state).centre.dot(*options.towards); };
  if (alike ? behind(other.state) < behind(best.state) : other.cost < best.cost) {
    std::swap(best, other);
  }
  const auto [estimate, unit] = estimate_of(model, best, static_cast<int>(cloud.size()), options, sphere_of);
  if (!unit) {
    return no_solution(
        "the points do not determine where the sphere is: they lie on its largest circle or on few points");
  }
  return judged(cloud, estimate, unit);
}

}  // namespace

Expected<Estimate<Sphere>> least_squares_sphere(const Cloud& cloud, const FitOptions& options) {
  return options.fixed_radius ? sphere_of_radius(cloud, options, *options.fixed_radius / cloud.scale)
                              : free_sphere(cloud, options);
}

}  // namespace artcal::fitting
