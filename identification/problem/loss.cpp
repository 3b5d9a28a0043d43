#include "identification/problem/loss.h"

#include <cmath>

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace artcal {
namespace {

constexpr double huber = 1.345;
constexpr double cauchy = 2.385;
constexpr double farthest = 12.0;  // standard deviations to which moments are integrated

}  // namespace

LossValue loss_at(Loss loss, double s) {
  switch (loss) {
    case Loss::Huber:
      return s <= huber * huber ? LossValue{s, 1.0}
                                : LossValue{2.0 * huber * std::sqrt(s) - huber * huber, huber / std::sqrt(s)};
    case Loss::Cauchy:
      return {cauchy * cauchy * std::log1p(s / (cauchy * cauchy)), 1.0 / (1.0 + s / (cauchy * cauchy))};
    case Loss::None: break;
  }
  return {s, 1.0};
}

LossValue loss_of(Loss loss, double squares, double expected) {
  if (!(expected > 0.0)) {
    return {squares, 1.0};
  }
  const LossValue rho = loss_at(loss, squares / expected);
  return {expected * rho.value, rho.slope};
}

LossMoments moments_of(Loss loss, double degrees_of_freedom) {
  const double n = degrees_of_freedom;
  // Over x = √χ², whose density has no pole: x^(n−1)·exp(−x²/2)/(2^(n/2−1)·Γ(n/2)).
  const double log_factor = -(0.5 * n - 1.0) * std::log(2.0) - std::lgamma(0.5 * n);
  const auto mean = [&](auto&& function) {
    const auto integrand = [&](double x) {
      const double s = x * x / n;
      return function(s, loss_at(loss, s).slope) * std::pow(x, n - 1.0) * std::exp(log_factor - 0.5 * x * x);
    };
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0.0, farthest, 10, 1e-9);
  };
  LossMoments moments;
  moments.square = mean([](double s, double slope) { return slope * slope * s; });
  moments.variance =
      mean([](double s, double slope) { return std::pow(slope, 4.0) * s * s; }) - moments.square * moments.square;
  const double derivative = mean([](double s, double slope) { return slope * s; });
  moments.information = derivative * derivative / (moments.square * mean([](double, double slope) { return slope; }));
  return moments;
}

}  // namespace artcal
