#include "fitting/criterion.h"

#include <type_traits>

#include "fitting/known.h"
#include "fitting/minimum_zone/minimum_circumscribed.h"
#include "fitting/minimum_zone/minimum_zone_plane.h"
#include "fitting/minimum_zone/radial_zone.h"

namespace artcal::fitting {
namespace {

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
    return F{};
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

}  // namespace

template <typename F>
Expected<Estimate<F>> estimate_by_criterion(const Cloud& cloud, const FitOptions& options) {
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

template Expected<Estimate<Sphere>> estimate_by_criterion(const Cloud&, const FitOptions&);
template Expected<Estimate<Plane>> estimate_by_criterion(const Cloud&, const FitOptions&);
template Expected<Estimate<Line>> estimate_by_criterion(const Cloud&, const FitOptions&);
template Expected<Estimate<Circle>> estimate_by_criterion(const Cloud&, const FitOptions&);
template Expected<Estimate<Cylinder>> estimate_by_criterion(const Cloud&, const FitOptions&);
template Expected<Estimate<Cone>> estimate_by_criterion(const Cloud&, const FitOptions&);

}  // namespace artcal::fitting
