#include "fitting/fit.h"

#include <type_traits>

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

}  // namespace

template <typename F>
Expected<Fitted<F>> fit(const Points& points, const FitOptions& options) {
  if (auto checked = check_options(options, Known<F>::abilities); !checked) {
    return tl::unexpected(checked.error());
  }
  if constexpr (std::is_same_v<F, Sphere>) {
    if (auto plain = fit_plain_sphere(points, options)) {
      return without_tip(std::move(*plain), options);
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
  return without_tip(std::move(fitted), options);
}

template Expected<Fitted<Sphere>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Plane>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Line>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Circle>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Cylinder>> fit(const Points&, const FitOptions&);
template Expected<Fitted<Cone>> fit(const Points&, const FitOptions&);

}  // namespace artcal
