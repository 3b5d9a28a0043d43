#include "identification/monte_carlo/monte_carlo_summary.h"

#include <algorithm>
#include <cmath>

namespace artcal {
namespace {

constexpr double probability = 0.95;
constexpr double beyond_chance = 3.0;  // standard deviations that u has from the number of trials

}  // namespace

std::vector<MonteCarloSummary> summary(const std::vector<Measurand>& quantities, const MonteCarloCount& count,
                                       int digits) {
  std::vector<MonteCarloSummary> all;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const Distribution& distribution = count.distributions[i];
    MonteCarloSummary result;
    result.mean = distribution.mean();
    result.u = distribution.deviation();
    result.symmetric = distribution.symmetric(probability);
    result.shortest = distribution.shortest(probability);
    const auto low = distribution.error_of_quantile(0.5 * (1.0 - probability));
    const auto high = distribution.error_of_quantile(0.5 * (1.0 + probability));
    // JCGM 101 §7.9.2: u as c·10^l with an integer c of so many digits; half of 10^l.
    const double l = result.u > 0.0 ? std::floor(std::log10(result.u)) - (digits - 1) : 0.0;
    result.tolerance_wanted = 0.5 * std::pow(10.0, l);
    result.tolerance = 2.0 * std::max({distribution.error_of_mean(), distribution.error_of_deviation(),
                                       low.value_or(0.0), high.value_or(0.0)});
    result.stable = low && high && result.tolerance <= result.tolerance_wanted;
    const auto& linear = quantities[i].u_linear;
    const double off = linear ? std::abs(result.u - *linear) : 0.0;
    result.differs_from_linear =
        linear && *linear > 0.0 && off > 0.1 * *linear && off > beyond_chance * distribution.error_of_deviation();
    all.push_back(result);
  }
  return all;
}

}  // namespace artcal
