#include "fitting/least_squares/estimate.h"

namespace artcal::fitting {
namespace {

// Directions, one unit of noise: across the widest spread the tilt is told best.
Eigen::Matrix3d spread_covariance(const Cloud& cloud, int first, int second, double s_first, double s_second) {
  const Eigen::Vector3d a = cloud.axes.col(first) / s_first;
  const Eigen::Vector3d b = cloud.axes.col(second) / s_second;
  return a * a.transpose() + b * b.transpose();
}

// A direction with a standard uncertainty above this (rad) is not determined.
constexpr double doubtful = 0.3;

}  // namespace

// The plane through the centroid, across the direction in which the points spread least: the right
// singular vectors of the centred points minimise Σ w·d² outright (Golub, Van Loan §12.3).
Expected<Estimate<Plane>> least_squares_plane(const Cloud& cloud, const FitOptions& options) {
  Estimate<Plane> estimate{{Eigen::Vector3d::Zero(), cloud.axes.col(2)}};
  estimate.degrees_of_freedom = static_cast<int>(cloud.size()) - 3;
  estimate.noise = noise_of(cloud, options, cloud.spread(2) * cloud.spread(2), estimate.degrees_of_freedom);
  const bool as_thick_as_wide = cloud.spread(2) > 0.3 * cloud.spread(1);
  if (as_thick_as_wide || noise_or_rounding(cloud, estimate.noise) > doubtful * cloud.spread(1)) {
    return no_solution(
        "the points do not determine a plane: they lie on one line, as far as their scatter shows; "
        "probe points beside it");
  }
  if (estimate.noise) {
    Covariance<Plane> unit = Covariance<Plane>::Zero();
    const Eigen::Vector3d& normal = cloud.axes.col(2);
    unit.topLeftCorner<3, 3>() = normal * normal.transpose() / cloud.total_weight();
    unit.bottomRightCorner<3, 3>() = spread_covariance(cloud, 0, 1, cloud.spread(0), cloud.spread(1));
    estimate.covariance = *estimate.noise * *estimate.noise * unit;
  }
  return estimate;
}

// Along the widest spread. Each point has two distances across the line, so two residuals.
Expected<Estimate<Line>> least_squares_line(const Cloud& cloud, const FitOptions& options) {
  Estimate<Line> estimate{{Eigen::Vector3d::Zero(), cloud.axes.col(0)}};
  estimate.degrees_of_freedom = 2 * static_cast<int>(cloud.size()) - 4;
  estimate.noise = noise_of(cloud, options, cloud.spread.tail<2>().squaredNorm(), estimate.degrees_of_freedom);
  const bool as_wide_as_long = cloud.spread(1) > 0.5 * cloud.spread(0);
  if (as_wide_as_long || noise_or_rounding(cloud, estimate.noise) > doubtful * cloud.spread(0)) {
    return no_solution(
        "the points do not determine a line: they scatter as far across it as along it; "
        "probe points further apart");
  }
  if (estimate.noise) {
    Covariance<Line> unit = Covariance<Line>::Zero();
    unit.topLeftCorner<3, 3>() = spread_covariance(cloud, 1, 2, 1.0, 1.0) / cloud.total_weight();
    unit.bottomRightCorner<3, 3>() = spread_covariance(cloud, 1, 2, cloud.spread(0), cloud.spread(0));
    estimate.covariance = *estimate.noise * *estimate.noise * unit;
  }
  return estimate;
}

}  // namespace artcal::fitting
