#pragma once

#include <span>

namespace artcal {

/// Root mean square; 0 for no values.
double root_mean_square(std::span<const double> values);

/// Largest absolute value; 0 for no values.
double max_abs(std::span<const double> values);

/// Median; REQUIRES at least one value. An even count gives the mean of the middle two.
double median(std::span<const double> values);

/// The value that a χ² variable with `degrees_of_freedom` > 0 stays below with `probability` in (0, 1).
double chi_squared_quantile(double probability, double degrees_of_freedom);

/// The probability that a χ² variable with `degrees_of_freedom` > 0 stays below `value` ≥ 0.
double chi_squared_probability(double value, double degrees_of_freedom);

/// The probability that an F variable with these degrees of freedom, both above 0, exceeds `value` ≥ 0.
double f_probability_above(double value, double numerator_freedom, double denominator_freedom);

}  // namespace artcal
