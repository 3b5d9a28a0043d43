#pragma once

#include <cstdint>
#include <vector>

#include "core/error.h"
#include "identification/monte_carlo/distribution.h"

namespace artcal {

/// Trials [first, end) that have been made, and all that is kept of them. Its size does not grow with their number.
/// Counts of trials that follow each other can be put together, and are then to the bit what one run would have
/// counted.
struct MonteCarloCount {
  std::int64_t first = 0, end = 0;
  std::int64_t not_converged = 0;
  std::vector<std::int64_t> not_converged_first;  ///< the first ten of them
  std::vector<Distribution> distributions;        ///< a quantity each
};

/// What a run of trials brought, one after the other from `first` on.
struct TrialResults {
  std::int64_t first = 0;
  std::vector<double> values;   ///< a row of quantities each; of no meaning where a trial did not converge
  std::vector<bool> converged;  ///< a trial each
};

/// Counts them all in `count`, whose distributions are the quantities, but for `end`: runs may come in any order.
void add_results(const TrialResults& results, MonteCarloCount& count);

/// Leaves the first ten of those that did not converge, in order.
void keep_the_first(std::vector<std::int64_t>& trials);

/// Appends trials that come right after. Usage: they do not, or were counted by other rulers.
Expected<void> append(MonteCarloCount& count, const MonteCarloCount& next);

}  // namespace artcal
