#include "core/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>

namespace artcal {

double root_mean_square(std::span<const double> values) {
  double sum = 0.0;
  for (const double v : values) {
    sum += v * v;
  }
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double max_abs(std::span<const double> values) {
  double largest = 0.0;
  for (const double v : values) {
    largest = std::max(largest, std::abs(v));
  }
  return largest;
}

double median(std::span<const double> values) {
  assert(!values.empty());
  std::vector<double> sorted(values.begin(), values.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  if (sorted.size() % 2 == 1) {
    return *middle;
  }
  return 0.5 * (*middle + *std::max_element(sorted.begin(), middle));
}

double chi_squared_quantile(double probability, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::chi_squared(degrees_of_freedom), probability);
}

double chi_squared_probability(double value, double degrees_of_freedom) {
  return boost::math::cdf(boost::math::chi_squared(degrees_of_freedom), value);
}

double f_probability_above(double value, double numerator_freedom, double denominator_freedom) {
  const boost::math::fisher_f distribution(numerator_freedom, denominator_freedom);
  return boost::math::cdf(boost::math::complement(distribution, value));
}

}  // namespace artcal
