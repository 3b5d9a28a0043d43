#include "core/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace artcal {
namespace {

// Boost computes doubles in long double otherwise, seven times as long for a last digit (differences of 6e-15 over
// probabilities from 1e-12 and 1 to 1e8 degrees of freedom; Fisher's would be 1e-9, and stays).
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Normal = boost::math::normal_distribution<double, InDouble>;
using ChiSquared = boost::math::chi_squared_distribution<double, InDouble>;
using StudentsT = boost::math::students_t_distribution<double, InDouble>;

}  // namespace

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
  return boost::math::quantile(ChiSquared(degrees_of_freedom), probability);
}

double chi_squared_probability_above(double value, double degrees_of_freedom) {
  return boost::math::cdf(boost::math::complement(ChiSquared(degrees_of_freedom), value));
}

double f_quantile_above(double probability, double numerator_freedom, double denominator_freedom) {
  const boost::math::fisher_f distribution(numerator_freedom, denominator_freedom);
  return boost::math::quantile(boost::math::complement(distribution, probability));
}

double normal_quantile(double probability) { return boost::math::quantile(Normal(), probability); }

double student_coverage_factor(double probability, double degrees_of_freedom) {
  const double tail = 0.5 * (1.0 - probability);
  if (std::isinf(degrees_of_freedom)) {
    return boost::math::quantile(boost::math::complement(Normal(), tail));
  }
  return boost::math::quantile(boost::math::complement(StudentsT(degrees_of_freedom), tail));
}

double significance_factor(std::size_t count, double degrees_of_freedom) {
  assert(count > 0);
  return student_coverage_factor(1.0 - 0.05 / static_cast<double>(count), degrees_of_freedom);
}

double stated_coverage_factor(double degrees_of_freedom) {
  return std::max(2.0, student_coverage_factor(0.95, degrees_of_freedom));
}

double student_limit_as_rare_as(double normal_limit, double degrees_of_freedom) {
  if (std::isinf(degrees_of_freedom)) {
    return normal_limit;
  }
  const double chance = boost::math::cdf(boost::math::complement(Normal(), normal_limit));
  return boost::math::quantile(boost::math::complement(StudentsT(degrees_of_freedom), chance));
}

double sigma_per_median() { return 1.0 / normal_quantile(0.75); }

double effective_degrees_of_freedom(std::span<const UncertaintyComponent> components) {
  double total = 0.0;
  for (const UncertaintyComponent& component : components) {
    total += component.u * component.u;
  }
  // Shares of the variance: fourth powers of micrometres in mm would be lost to rounding beside nothing.
  double inverse = 0.0;
  for (const UncertaintyComponent& component : components) {
    const double share = total > 0.0 ? component.u * component.u / total : 0.0;
    inverse += share * share / component.degrees_of_freedom;
  }
  return inverse > 0.0 ? 1.0 / inverse : std::numeric_limits<double>::infinity();
}

}  // namespace artcal
