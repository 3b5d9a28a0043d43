#include "fitting/fit.h"

#include <cmath>
#include <type_traits>

#include "fitting/estimate.h"
#include "fitting/extreme.h"
#include "fitting/fast_sphere.h"
#include "fitting/options.h"
#include "fitting/tip.h"

namespace artcal {
namespace {

using namespace fitting;

template <typename F>
struct Known;
template <>
struct Known<Sphere> {
  static constexpr Demand demand{"sphere", 4, 3};
  static constexpr Abilities abilities{"sphere", true, true, true, true, false};
  static constexpr auto least_squares = least_squares_sphere;
};
template <>
struct Known<Plane> {
  static constexpr Demand demand{"plane", 3, 2};
  static constexpr Abilities abilities{"plane", true, false, false, true, true};
  static constexpr auto least_squares = least_squares_plane;
};
template <>
struct Known<Line> {
  static constexpr Demand demand{"line", 2, 1};
  static constexpr Abilities abilities{"line", false, false, false, false, false};
  static constexpr auto least_squares = least_squares_line;
};
template <>
struct Known<Circle> {
  static constexpr Demand demand{"circle", 3, 2};
  static constexpr Abilities abilities{"circle", true, true, false, true, false};
  static constexpr auto least_squares = least_squares_circle;
};
template <>
struct Known<Cylinder> {
  static constexpr Demand demand{"cylinder", 5, 3};
  static constexpr Abilities abilities{"cylinder", false, false, false, true, false};
  static constexpr auto least_squares = least_squares_cylinder;
};
template <>
struct Known<Cone> {
  static constexpr Demand demand{"cone", 6, 3};
  static constexpr Abilities abilities{"cone", false, false, false, true, false};
  static constexpr auto least_squares = least_squares_cone;
};

// What is asked of the points: a sphere of known radius, or one that a few points bound, needs less.
template <typename F>
Demand demand_for(const FitOptions& options) {
  Demand demand = Known<F>::demand;
  if (std::is_same_v<F, Sphere> && options.fixed_radius) {
    demand.points = 3;
    demand.dimensions = 2;
  } else if (options.criterion == Criterion::MinimumCircumscribed) {
    demand.points = std::is_same_v<F, Circle> ? 3 : 2;
    demand.dimensions = std::is_same_v<F, Circle> ? 2 : 1;
  }
  return demand;
}

template <int Dimension>
Expected<Ball<Dimension>> extreme_ball(Criterion criterion, const BallPoints<Dimension>& points,
                                       const Eigen::Matrix<double, Dimension, 1>& start) {
  switch (criterion) {
    case Criterion::MinimumZone: return minimum_zone<Dimension>(points, start);
    case Criterion::MaximumInscribed: return maximum_inscribed<Dimension>(points, start);
    default: return minimum_circumscribed<Dimension>(points);
  }
}

// The least-squares centre to start from; the smallest enclosing ball needs none, and fewer points.
template <typename F>
Expected<F> start_of(const Cloud& cloud, const FitOptions& options) {
  if (options.criterion == Criterion::MinimumCircumscribed) {
    F origin = {};
    origin.centre.setZero();
    return origin;
  }
  return Known<F>::least_squares(cloud, options).map([](const Estimate<F>& estimate) { return estimate.feature; });
}

Expected<Sphere> extreme(const Cloud& cloud, const FitOptions& options, const Sphere& start) {
  return extreme_ball<3>(options.criterion, cloud.points, start.centre).map([](const Ball<3>& ball) {
    return Sphere{ball.centre, ball.radius};
  });
}

Expected<Circle> extreme(const Cloud& cloud, const FitOptions& options, const Circle& start) {
  const Eigen::Matrix<double, 3, 2> flat = cloud.axes.leftCols<2>();
  const BallPoints<2> points = flat.transpose() * cloud.points;
  const Eigen::Vector2d centre = flat.transpose() * start.centre;
  return extreme_ball<2>(options.criterion, points, centre).map([&](const Ball<2>& ball) {
    return Circle{flat * ball.centre, cloud.axes.col(2), ball.radius};
  });
}

// An estimate in the cloud's frame and unit, by whichever criterion.
template <typename F>
Expected<Estimate<F>> estimate(const Cloud& cloud, const FitOptions& options) {
  if (options.criterion == Criterion::LeastSquares) {
    return Known<F>::least_squares(cloud, options);
  }
  if constexpr (std::is_same_v<F, Plane>) {
    Estimate<F> result;
    result.feature = minimum_zone_plane(cloud);
    return result;
  } else if constexpr (std::is_same_v<F, Sphere> || std::is_same_v<F, Circle>) {
    FitOptions start_options = options;
    start_options.circle = CircleConvention::Projected;
    return start_of<F>(cloud, start_options)
        .and_then([&](const F& start) { return extreme(cloud, options, start); })
        .map([](const F& feature) {
          Estimate<F> result;
          result.feature = feature;
          return result;
        });
  } else {
    return Known<F>::least_squares(cloud, options);
  }
}

// From the cloud's frame and unit to the points'. Lengths are the first three parameters, the sphere's
// fourth, and the seventh of what is round about an axis.
void to_frame(const Cloud& cloud, Sphere& f) { f = {cloud.centroid + cloud.scale * f.centre, cloud.scale * f.radius}; }
void to_frame(const Cloud& cloud, Plane& f) { f.point = cloud.centroid + cloud.scale * f.point; }
void to_frame(const Cloud& cloud, Line& f) { f.point = cloud.centroid + cloud.scale * f.point; }
void to_frame(const Cloud& cloud, Circle& f) {
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

// Residuals of all points; form and rms of those with a weight.
template <typename F>
void describe(const Points& points, const FitOptions& options, Fitted<F>& fitted) {
  fitted.residuals.resize(points.cols());
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double squares = 0.0;
  double weights = 0.0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double d = fitted.residuals(i) = residual(fitted.feature, options, points.col(i));
    const double weight = options.weights.size() == 0 ? 1.0 : options.weights(i);
    if (weight > 0.0) {
      low = std::min(low, d);
      high = std::max(high, d);
      squares += weight * d * d;
      weights += weight;
    }
  }
  fitted.form = std::is_same_v<F, Line> ? 2.0 * high : high - low;
  fitted.rms = std::sqrt(squares / weights);
}

// The fit sees the surface that the tip's centres lie on.
FitOptions before_tip(FitOptions options) {
  if (options.fixed_radius) {
    *options.fixed_radius += tip_offset(options);
  }
  return options;
}

template <typename F>
Expected<Fitted<F>> without_tip(Fitted<F> fitted, const FitOptions& options) {
  if (options.tip_radius > 0.0) {
    if (auto taken = take_tip_off(fitted.feature, options); !taken) {
      return tl::unexpected(taken.error());
    }
  }
  return fitted;
}

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
  const auto cloud = make_cloud(points, options.weights, demand_for<F>(options));
  if (!cloud) {
    return tl::unexpected(cloud.error());
  }
  const auto found = estimate<F>(*cloud, before_tip(options));
  if (!found) {
    return tl::unexpected(found.error());
  }
  Fitted<F> fitted = in_frame(*cloud, *found);
  orient(fitted.feature, options);
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
