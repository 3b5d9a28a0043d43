#pragma once

#include <optional>
#include <vector>

#include "identification/monte_carlo/monte_carlo_count.h"
#include "identification/monte_carlo/simulated_measurement.h"

namespace artcal {

/// What came out for one quantity.
struct MonteCarloSummary {
  double mean = 0.0;
  double u = 0.0;
  std::optional<Interval> symmetric, shortest;  ///< 95 %; absent where an end lies beyond the histogram
  /// Of mean, u and the ends of the symmetric interval together: twice the largest of their standard deviations
  /// from the number of trials.
  double tolerance = 0.0;
  double tolerance_wanted = 0.0;     ///< half of the last of the wanted digits of u
  bool stable = false;               ///< tolerance ≤ tolerance_wanted
  bool differs_from_linear = false;  ///< u by more than a tenth of the first-order one, and beyond chance
};

/// REQUIRES: two trials or more.
std::vector<MonteCarloSummary> summary(const std::vector<Measurand>& quantities, const MonteCarloCount& count,
                                       int digits = 2);

}  // namespace artcal
