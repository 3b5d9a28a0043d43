#include "fitting/fit.h"

#include <optional>
#include <type_traits>
#include <vector>

#include "fitting/chosen_points.h"
#include "fitting/cloud.h"
#include "fitting/criterion.h"
#include "fitting/known.h"
#include "fitting/least_squares/fast_sphere.h"
#include "fitting/options.h"
#include "fitting/result.h"
#include "fitting/tip.h"

namespace artcal {
namespace {

using namespace fitting;

// The fit sees the surface that the tip's centres lie on.
FitOptions before_tip(FitOptions options) {
  if (options.fixed_radius) {
    *options.fixed_radius += tip_offset(options);
  }
  return options;
}

// A turned direction takes its covariance along: rows and columns three to five change sign.
template <typename F>
void orient(Fitted<F>& fitted, const FitOptions& options) {
  Eigen::Vector3d* direction = turnable(fitted.feature);
  if (direction == nullptr || !points_away(*direction, options)) {
    return;
  }
  *direction = -*direction;
  if constexpr (F::parameter_count >= 6) {
    if (fitted.covariance) {
      fitted.covariance->template middleRows<3>(3) *= -1.0;
      fitted.covariance->template middleCols<3>(3) *= -1.0;
    }
  }
}

template <typename F>
Expected<Fitted<F>> without_tip(Fitted<F> fitted, const FitOptions& options) {
  if constexpr (std::is_same_v<F, Sphere>) {
    if (options.fixed_radius) {
      fitted.feature.radius = *options.fixed_radius;  // to the last digit
      return fitted;
    }
  }
  if (options.tip_radius > 0.0) {
    if (auto taken = take_tip_off(fitted.feature, options); !taken) {
      return tl::unexpected(taken.error());
    }
  }
  return fitted;
}

template <typename F>
std::optional<Fitted<F>> fit_chosen(const Points& points, const FitOptions& options);

// Before the tip is taken off.
template <typename F>
Expected<Fitted<F>> fit_centres(const Points& points, const FitOptions& options) {
  if (auto chosen = fit_chosen<F>(points, options)) {
    return std::move(*chosen);
  }
  if constexpr (std::is_same_v<F, Sphere>) {
    if (auto plain = fit_plain_sphere(points, options)) {
      return std::move(*plain);
    }
  }
  auto cloud = make_cloud(points, options.weights, requirement_for<F>(options));
  if (!cloud) {
    return tl::unexpected(cloud.error());
  }
  if (options.circle_normal) {
    turn_axes(*cloud, *options.circle_normal);
  }
  const auto found = estimate_by_criterion<F>(*cloud, before_tip(options));
  if (!found) {
    return tl::unexpected(found.error());
  }
  Fitted<F> fitted = in_frame(*cloud, *found);
  orient(fitted, options);
  describe(points, options, fitted);
  return fitted;
}

// Where weights only say which of many points take part, these are fitted alone: points without weights take less time.
// Nothing where weights say more, and where the points chosen are no feature, which is then said of all.
template <typename F>
std::optional<Fitted<F>> fit_chosen(const Points& points, const FitOptions& options) {
  constexpr Eigen::Index many = 20'000;
  const auto weights = options.weights.array();
  if (weights.size() < many || weights.size() != points.cols() || !(weights == 0.0 || weights == 1.0).all() ||
      first_not_finite(points) >= 0) {
    return std::nullopt;
  }
  FitOptions plain = options;
  plain.weights.resize(0);
  auto fitted = fit_centres<F>(
      points_where(points, [&](std::size_t i) { return options.weights[static_cast<Eigen::Index>(i)] > 0.0; }), plain);
  if (!fitted) {
    return std::nullopt;
  }
  describe(points, options, *fitted);
  return std::move(*fitted);
}

}  // namespace

template <typename F>
Expected<Fitted<F>> fit(const Points& points, const FitOptions& options) {
  if (auto checked = check_options(options, Known<F>::abilities); !checked) {
    return tl::unexpected(checked.error());
  }
  auto fitted = fit_centres<F>(points, options);
  return fitted ? without_tip(std::move(*fitted), options) : fitted;
}

template Expected<Fitted<Sphere>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Plane>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Line>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Circle>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Cylinder>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Cone>> fit(const Points&, const FitOptions&);

}  // namespace artcal
