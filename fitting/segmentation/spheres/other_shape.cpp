#include "fitting/segmentation/spheres/other_shape.h"

#include <algorithm>
#include <cmath>

namespace artcal::segmentation {
namespace {

constexpr Eigen::Index most_points = 200;  // time goes with them, and more tell no more of the shape

Eigen::Matrix3Xd thinned(const Eigen::Matrix3Xd& points) {
  if (points.cols() <= most_points) {
    return points;
  }
  // Multiples of the golden ratio: no step of a scanner's raster repeats in them.
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  Eigen::Matrix3Xd few(3, most_points);
  for (Eigen::Index i = 0; i < most_points; ++i) {
    const double part = golden * static_cast<double>(i);
    few.col(i) = points.col(static_cast<Eigen::Index>((part - std::floor(part)) * static_cast<double>(points.cols())));
  }
  return few;
}

// Whether the sum of squared distances to the feature exceeds that of the sphere by more than noise makes of it.
template <typename F>
bool is_worse(const Eigen::Matrix3Xd& points, const Fitted<Sphere>& sphere) {
  constexpr double beyond_chance = 16.0;  // variances of a point: four standard deviations of a misfit
  const auto other = fit<F>(points);
  if (!other) {
    return true;  // the points do not determine one
  }
  const double squares = sphere.residuals.squaredNorm();
  const double variance = squares / std::max(1.0, static_cast<double>(points.cols() - Sphere::parameter_count));
  return other->residuals.squaredNorm() - squares > beyond_chance * variance;
}

}  // namespace

std::optional<std::string_view> other_shape(const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd few = thinned(points);
  const auto sphere = fit<Sphere>(few);
  if (!sphere) {
    return std::nullopt;
  }
  if (!is_worse<Cylinder>(few, *sphere)) {
    return "cylinder";
  }
  if (!is_worse<Cone>(few, *sphere)) {
    return "cone";
  }
  return std::nullopt;
}

}  // namespace artcal::segmentation
