#include "fitting/outlier_test.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>

namespace artcal::fitting {
namespace {

// Of a normal residual of one or two dimensions, in standard deviations.
double log_probability_beyond(double distance, int dimensions) {
  return dimensions == 2 ? -0.5 * distance * distance : std::log(std::erfc(distance / std::sqrt(2.0)));
}

// Mean over the noise s, where ν·s² is χ² with ν degrees of freedom. The integrand over ln s is one smooth peak between
// s = 1/distance and s = 1, and no narrower than 1/√(2ν + k): the trapezoidal rule has all digits that are needed.
double probability_all_beyond(double distance, int count, int dimensions, double degrees_of_freedom) {
  if (std::isinf(degrees_of_freedom)) {
    return std::exp(count * log_probability_beyond(distance, dimensions));
  }
  const boost::math::chi_squared distribution(degrees_of_freedom);
  const double step = 0.3 / std::sqrt(2.0 * degrees_of_freedom + count + 10.0);
  const double lowest = -std::log(std::max(1.0, distance)) - 16.0;
  double sum = 0.0;
  for (double log_s = lowest; log_s < 2.0; log_s += step) {
    const double s = std::exp(log_s);
    const double squares = degrees_of_freedom * s * s;
    const double density = boost::math::pdf(distribution, squares) * 2.0 * squares;
    sum += step * density * std::exp(count * log_probability_beyond(distance * s, dimensions));
  }
  return sum;
}

double log_subsets(int n, int k) { return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0); }

}  // namespace

bool are_outliers(double distance, const LeftOutPoints& left_out, double chance) {
  const auto& [points, count, dimensions, degrees_of_freedom] = left_out;
  if (probability_all_beyond(distance, 1, dimensions, degrees_of_freedom) > chance) {
    return false;
  }
  const double all = probability_all_beyond(distance, count, dimensions, degrees_of_freedom);
  return log_subsets(points, count) + std::log(all) <= std::log(points * chance);
}

}  // namespace artcal::fitting
