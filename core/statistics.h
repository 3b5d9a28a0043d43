#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace artcal {

/// Median; REQUIRES at least one value. An even count gives the mean of the middle two.
double median(std::span<const double> values);

/// The value that a χ² variable with `degrees_of_freedom` > 0 stays below with `probability` in (0, 1).
double chi_squared_quantile(double probability, double degrees_of_freedom);

/// The probability that a χ² variable with `degrees_of_freedom` > 0 exceeds `value` ≥ 0.
double chi_squared_probability_above(double value, double degrees_of_freedom);

/// The value that an F variable with these degrees of freedom, both above 0, exceeds with `probability` in (0, 1).
double f_quantile_above(double probability, double numerator_freedom, double denominator_freedom);

/// The value that a standard normal variable stays below with `probability` in (0, 1).
double normal_quantile(double probability);

/// Coverage factor of the symmetric interval that holds a Student t variable with `probability` in (0, 1); the normal
/// one for infinite degrees of freedom. `degrees_of_freedom` > 0 need not be an integer (JCGM 100, G.4).
double student_coverage_factor(double probability, double degrees_of_freedom);

/// The one rule by which a change of one of `count` ≥ 1 values is called significant: beyond this many standard
/// uncertainties, where all together are exceeded by chance in one of twenty cases (Student, Bonferroni).
double significance_factor(std::size_t count, double degrees_of_freedom);

/// Coverage factor of the expanded uncertainties that are stated: k = 2, which is about 95 % where u is known well, and
/// Student's factor for 95 % where that is larger, below 60 degrees of freedom (JCGM 100, G.3; EA-4/02, annex E).
double stated_coverage_factor(double degrees_of_freedom);

/// The value that a Student t variable exceeds as rarely as a standard normal one exceeds `normal_limit` ≥ 0, which
/// must be below 38 (where that is never, in doubles).
double student_limit_as_rare_as(double normal_limit, double degrees_of_freedom);

/// Standard deviation of normal values with mean zero by the median of their absolute values: 1/Φ⁻¹(3/4) = 1.4826….
double sigma_per_median();

/// One component of a combined standard uncertainty and how well it is known; infinite: exactly.
struct UncertaintyComponent {
  double u = 0.0;
  double degrees_of_freedom = std::numeric_limits<double>::infinity();
};

/// Effective degrees of freedom of √(Σu²) (Welch, Satterthwaite; JCGM 100, G.2b); infinite where all components are
/// known exactly or zero.
double effective_degrees_of_freedom(std::span<const UncertaintyComponent> components);

}  // namespace artcal
