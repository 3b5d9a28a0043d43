#include "fitting/least_squares/fast_sphere.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/large_pages.h"
#include "fitting/least_squares/sphere_kernel.h"
#include "fitting/point_blocks.h"

namespace artcal::fitting {
namespace {

// Normal equations here cost no digits: the step they give is refined by the next, whose gradient is a
// sum of small residuals, and the well spread points that are let through have a condition near one.
constexpr double plain = 1e-3;               // smallest eigenvalue of the mean of J·Jᵀ; a ball has 1/3
constexpr Eigen::Index thin_above = 20'000;  // from here on a part of the points finds the start
constexpr double arrived = 1e-13;            // of the radius

SphereView view_of(const Points& points, const Eigen::Vector3d& origin, const Sphere& at) {
  return {points.data(),
          static_cast<std::size_t>(points.cols()),
          {origin.x(), origin.y(), origin.z()},
          {at.centre.x(), at.centre.y(), at.centre.z()},
          at.radius};
}

// Calls pass(points, the first one's number) for each block.
template <typename Result, typename Pass>
std::vector<Result> in_blocks(const SphereView& all, const Pass& pass) {
  return of_each_block<Result>(all.count, [&](std::size_t begin, std::size_t end) {
    SphereView part = all;
    part.xyz += 3 * begin;
    part.count = end - begin;
    return pass(part, begin);
  });
}

SphereGradient& operator+=(SphereGradient& sum, const SphereGradient& part) {
  for (int i = 0; i < 3; ++i) {
    sum.du[i] += part.du[i];
  }
  sum.d += part.d;
  sum.dd += part.dd;
  return sum;
}

SphereSums& operator+=(SphereSums& sum, const SphereSums& part) {
  sum.gradient += part.gradient;
  for (int i = 0; i < 3; ++i) {
    sum.u[i] += part.u[i];
  }
  for (int i = 0; i < 6; ++i) {
    sum.uuf[i] += part.uuf[i];
  }
  sum.f += part.f;
  return sum;
}

template <typename Sums>
Sums total(const std::vector<Sums>& parts) {
  Sums sum = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    sum += parts[i];
  }
  return sum;
}

SphereSums sums_of(const SphereView& view) {
  if (view.count <= points_of_a_block) {
    return sphere_sums(view);
  }
  return total(in_blocks<SphereSums>(view, [](const SphereView& part, std::size_t) { return sphere_sums(part); }));
}

SphereGradient gradient_of(const SphereView& view) {
  if (view.count <= points_of_a_block) {
    return sphere_gradient(view);
  }
  return total(
      in_blocks<SphereGradient>(view, [](const SphereView& part, std::size_t) { return sphere_gradient(part); }));
}

SphereResiduals residuals_of(const SphereView& view, double* d) {
  if (view.count <= points_of_a_block) {
    return sphere_residuals(view, d);
  }
  const auto parts = in_blocks<SphereResiduals>(
      view, [&](const SphereView& part, std::size_t first) { return sphere_residuals(part, d + first); });
  SphereResiduals all = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    all = {std::min(all.low, parts[i].low), std::max(all.high, parts[i].high), all.dd + parts[i].dd};
  }
  return all;
}

// Runs of neighbours, spread over the whole: as cheap to read as they come.
Eigen::Matrix3Xd part_of(const Points& points) {
  constexpr Eigen::Index run = 64;
  constexpr Eigen::Index stride = 32 * run;
  const Eigen::Index runs = points.cols() / stride;
  Eigen::Matrix3Xd part(3, runs * run);
  for (Eigen::Index i = 0; i < runs; ++i) {
    part.middleCols(i * run, run) = points.middleCols(i * stride, run);
  }
  return part;
}

// |q|² = 2·c·q + t over up to some hundred points, from the origin.
std::optional<Sphere> linear_start(const Points& points, const Eigen::Vector3d& origin) {
  const Eigen::Index step = std::max<Eigen::Index>(1, points.cols() / 256);
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d rhs = Eigen::Vector4d::Zero();
  for (Eigen::Index i = 0; i < points.cols(); i += step) {
    const Eigen::Vector3d q = points.col(i) - origin;
    const Eigen::Vector4d row{2.0 * q.x(), 2.0 * q.y(), 2.0 * q.z(), 1.0};
    normal.noalias() += row * row.transpose();
    rhs += q.squaredNorm() * row;
  }
  const Eigen::Vector4d x = normal.ldlt().solve(rhs);
  const Sphere start{x.head<3>(), std::sqrt(x(3) + x.head<3>().squaredNorm())};
  return std::isfinite(start.radius) && start.radius > 0.0 ? std::optional(start) : std::nullopt;
}

// Hessian of Σ d²/2 by (c, R): Σ (1 − R/ρ)·I + (R/ρ)·û·ûᵀ, Σ û, n.
Eigen::Matrix4d hessian(const SphereSums& s, double radius, double count) {
  const double spare = count - radius * s.f;
  Eigen::Matrix4d h;
  h << spare + radius * s.uuf[0], radius * s.uuf[1], radius * s.uuf[2], s.u[0],  //
      radius * s.uuf[1], spare + radius * s.uuf[3], radius * s.uuf[4], s.u[1],   //
      radius * s.uuf[2], radius * s.uuf[4], spare + radius * s.uuf[5], s.u[2],   //
      s.u[0], s.u[1], s.u[2], count;
  return h;
}

Eigen::Vector4d downhill(const SphereGradient& g) { return {g.du[0], g.du[1], g.du[2], g.d}; }

Sphere moved(const Sphere& at, const Eigen::Vector4d& step) {
  return {at.centre + step.head<3>(), at.radius + step(3)};
}

struct Bottom {
  Sphere sphere;
  Eigen::Matrix4d inverse;  // of the Hessian; nothing for a radius that is known
  int steps;
};

// Points that tell the radius too leave no doubt on which side of them a sphere of known radius is.
struct Inverse {
  Eigen::Matrix4d matrix;
  bool well_spread;
};

bool well_spread(const Eigen::Matrix4d& inverse, double count) {
  // Frobenius norm of the inverse bounds 1/λ from above.
  return std::isfinite(inverse.sum()) && inverse.norm() * count < 1.0 / plain && inverse.diagonal().minCoeff() > 0.0;
}

Inverse inverse_of(const Eigen::Matrix4d& h, double count, bool radius_is_known) {
  Inverse inverse{h.inverse(), false};
  inverse.well_spread = well_spread(inverse.matrix, count);
  if (radius_is_known) {
    inverse.matrix.setZero();
    inverse.matrix.topLeftCorner<3, 3>() = h.topLeftCorner<3, 3>().inverse();
  }
  return inverse;
}

// Newton's method; each step leaves its own square of the way.
std::optional<Bottom> newton(const Points& points, const Eigen::Vector3d& origin, const Sphere& start,
                             bool radius_is_known) {
  constexpr int max_steps = 20;
  const auto count = static_cast<double>(points.cols());
  Bottom bottom{start, {}, 0};
  while (bottom.steps < max_steps) {
    Sphere& at = bottom.sphere;
    const SphereSums sums = sums_of(view_of(points, origin, at));
    const Inverse inverse = inverse_of(hessian(sums, at.radius, count), count, radius_is_known);
    bottom.inverse = inverse.matrix;
    const Eigen::Vector4d step = bottom.inverse * downhill(sums.gradient);
    const double relative = step.cwiseAbs().maxCoeff() / at.radius;
    if (!inverse.well_spread || !(relative < 0.5)) {
      return std::nullopt;
    }
    at = moved(at, step);
    ++bottom.steps;
    if (relative < 1e-8) {
      return bottom;
    }
  }
  return std::nullopt;
}

// The same from a start found on a part of the points, reading all of them once or twice only. The part
// also knows how the cost bends between there and the bottom, so its gradient, corrected to the value and
// slope that all points have at the start (Shamir, Srebro, Zhang 2014), stands in for theirs: what is left
// after that is the part's error, 1/√m, in a term that is of second order itself.
std::optional<Bottom> newton_by_part(const Points& points, const Points& part, const Eigen::Vector3d& origin,
                                     const Sphere& start, bool radius_is_known) {
  constexpr int max_steps = 20;
  const auto count = static_cast<double>(points.cols());
  const double share = count / static_cast<double>(part.cols());
  const SphereSums all = sums_of(view_of(points, origin, start));
  const SphereSums some = sums_of(view_of(part, origin, start));
  const Eigen::Matrix4d bend = hessian(all, start.radius, count);
  const Eigen::Matrix4d lacking = bend - share * hessian(some, start.radius, static_cast<double>(part.cols()));
  const Inverse inverse = inverse_of(bend, count, radius_is_known);
  Bottom bottom{start, inverse.matrix, 1};
  if (!inverse.well_spread) {
    return std::nullopt;
  }
  Eigen::Vector4d way = bottom.inverse * downhill(all.gradient);
  const double relative = way.cwiseAbs().maxCoeff() / start.radius;
  for (int i = 0; i < 2; ++i) {
    const SphereGradient here = gradient_of(view_of(part, origin, moved(start, way)));
    const Eigen::Vector4d gradient =
        downhill(all.gradient) + share * (downhill(here) - downhill(some.gradient)) - lacking * way;
    way += bottom.inverse * gradient;
  }
  bottom.sphere = moved(start, way);
  double left = 0.5 * relative * relative / std::sqrt(static_cast<double>(part.cols()));
  while (left > arrived) {
    const SphereGradient here = gradient_of(view_of(points, origin, bottom.sphere));
    const Eigen::Vector4d step = bottom.inverse * downhill(here);
    left = step.cwiseAbs().maxCoeff() / start.radius * std::max(relative, 1e-3);
    bottom.sphere = moved(bottom.sphere, step);
    if (++bottom.steps > max_steps) {
      return std::nullopt;
    }
  }
  return bottom;
}

std::optional<Bottom> descend(const Points& points, const Eigen::Vector3d& origin, std::optional<double> radius) {
  if (points.cols() < thin_above) {
    auto start = linear_start(points, origin);
    if (start && radius) {
      start->radius = *radius;
    }
    return start ? newton(points, origin, *start, radius.has_value()) : std::nullopt;
  }
  const Eigen::Matrix3Xd part = part_of(points);
  const auto start = descend(part, origin, radius);
  return start ? newton_by_part(points, part, origin, start->sphere, radius.has_value()) : std::nullopt;
}

bool is_plain(const Points& points, const FitOptions& options) {
  constexpr Eigen::Index fewest = 5;
  return points.cols() >= fewest && points.outerStride() == 3 && options.criterion == Criterion::LeastSquares &&
         options.weights.size() == 0 && !(options.fixed_radius && options.tip_radius > 0.0);
}

}  // namespace

std::optional<Fitted<Sphere>> fit_plain_sphere(const Points& points, const FitOptions& options) {
  if (!is_plain(points, options)) {
    return std::nullopt;
  }
  const Eigen::Index some = std::max<Eigen::Index>(1, points.cols() / 256);
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < points.cols(); i += some) {
    origin += points.col(i);
  }
  origin /= static_cast<double>((points.cols() + some - 1) / some);
  const auto bottom = descend(points, origin, options.fixed_radius);
  if (!bottom) {
    return std::nullopt;
  }
  Fitted<Sphere> fitted;
  fitted.residuals.resize(points.cols());
  prefer_large_pages(fitted.residuals.data(), static_cast<std::size_t>(points.cols()) * sizeof(double));
  const auto residuals = residuals_of(view_of(points, origin, bottom->sphere), fitted.residuals.data());
  const auto count = static_cast<double>(points.cols());
  fitted.feature = {origin + bottom->sphere.centre, bottom->sphere.radius};
  fitted.form = residuals.high - residuals.low;
  fitted.rms = std::sqrt(residuals.dd / count);
  fitted.degrees_of_freedom = static_cast<int>(points.cols()) - (options.fixed_radius ? 3 : 4);
  fitted.noise = options.noise.value_or(std::sqrt(residuals.dd / fitted.degrees_of_freedom));
  fitted.covariance = *fitted.noise * *fitted.noise * bottom->inverse;
  fitted.steps = bottom->steps;
  // Hardly determined, wildly scattered, or determined by what may be scatter (on_one_circle() in sphere.cpp): not
  // plain.
  constexpr double sure = 3.0;
  const double scatter = *fitted.noise / fitted.feature.radius;
  const bool is_sure = sure * sure * scatter * scatter * count * bottom->inverse.norm() < 1.0;
  if (!(std::sqrt(fitted.covariance->diagonal().maxCoeff()) < 0.1 * fitted.feature.radius &&
        fitted.rms < 0.1 * fitted.feature.radius && is_sure)) {
    return std::nullopt;
  }
  return fitted;
}

}  // namespace artcal::fitting
