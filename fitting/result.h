#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "core/large_pages.h"
#include "fitting/least_squares/estimate.h"
#include "fitting/point_blocks.h"

namespace artcal::fitting {

/// From the cloud's frame and unit to the points'. Lengths are the first three parameters, the sphere's
// fourth, and the seventh of what is round about an axis.
inline void to_frame(const Cloud& cloud, Sphere& f) {
  f = {cloud.centroid + cloud.scale * f.centre, cloud.scale * f.radius};
}
inline void to_frame(const Cloud& cloud, Plane& f) { f.point = cloud.centroid + cloud.scale * f.point; }
inline void to_frame(const Cloud& cloud, Line& f) { f.point = cloud.centroid + cloud.scale * f.point; }
inline void to_frame(const Cloud& cloud, Circle& f) {
  f = {cloud.centroid + cloud.scale * f.centre, f.normal, cloud.scale * f.radius};
}
template <typename Axial>
void to_frame(const Cloud& cloud, Axial& f) {
  f.point = cloud.centroid + cloud.scale * f.point;
  f.radius *= cloud.scale;
}

template <typename F>
Covariance<F> in_millimetres(const Cloud& cloud, const Covariance<F>& covariance) {
  Eigen::Matrix<double, F::parameter_count, 1> unit = Eigen::Matrix<double, F::parameter_count, 1>::Ones();
  for (int i = 0; i < F::parameter_count; ++i) {
    if (i < 3 || i == 6 || std::is_same_v<F, Sphere>) {
      unit(i) = cloud.scale;
    }
  }
  return unit.asDiagonal() * covariance * unit.asDiagonal();
}

template <typename F>
double residual(const F& feature, const FitOptions& options, const Eigen::Vector3d& p) {
  if constexpr (std::is_same_v<F, Circle>) {
    const bool flat = options.criterion != Criterion::LeastSquares || options.circle == CircleConvention::Projected;
    return flat ? radial_distance(feature, p) : signed_distance(feature, p);
  } else {
    return signed_distance(feature, p);
  }
}

/// What residuals come to.
struct ResidualSums {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double squares = 0.0, weights = 0.0;

  void add(double residual, double weight) {
    low = std::min(low, residual);
    high = std::max(high, residual);
    squares += weight * residual * residual;
    weights += weight;
  }
  void add(const ResidualSums& part) {
    low = std::min(low, part.low);
    high = std::max(high, part.high);
    squares += part.squares;
    weights += part.weights;
  }
};

/// Residuals of all points; form and rms of those with a weight. Blocks of many points are summed side by side and
/// added in their order.
template <typename F>
void describe(const Points& points, const FitOptions& options, Fitted<F>& fitted) {
  const auto count = static_cast<std::size_t>(points.cols());
  fitted.residuals.resize(points.cols());
  prefer_large_pages(fitted.residuals.data(), count * sizeof(double));
  const auto parts = of_each_block<ResidualSums>(count, [&](std::size_t begin, std::size_t end) {
    ResidualSums part;
    for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i) {
      const double d = fitted.residuals(i) = residual(fitted.feature, options, points.col(i));
      const double weight = options.weights.size() == 0 ? 1.0 : options.weights(i);
      if (weight > 0.0) {
        part.add(d, weight);
      }
    }
    return part;
  });
  ResidualSums sums;
  for (const ResidualSums& part : parts) {
    sums.add(part);
  }
  fitted.form = std::is_same_v<F, Line> ? 2.0 * sums.high : sums.high - sums.low;
  fitted.rms = std::sqrt(sums.squares / sums.weights);
}

/// What the caller gets, but for what its points say.
template <typename F>
Fitted<F> in_frame(const Cloud& cloud, const Estimate<F>& estimate) {
  Fitted<F> fitted;
  fitted.feature = estimate.feature;
  to_frame(cloud, fitted.feature);
  fitted.degrees_of_freedom = estimate.degrees_of_freedom;
  fitted.status = estimate.status;
  fitted.steps = estimate.steps;
  if (estimate.noise) {
    fitted.noise = *estimate.noise * cloud.scale;
  }
  if (estimate.covariance) {
    fitted.covariance = in_millimetres<F>(cloud, *estimate.covariance);
  }
  return fitted;
}

}  // namespace artcal::fitting
