#include "identification/monte_carlo/monte_carlo_count.h"

#include <algorithm>

#include <fmt/format.h>

namespace artcal {
namespace {

constexpr std::size_t failures_listed = 10;

}  // namespace

void add_results(const TrialResults& results, MonteCarloCount& count) {
  const std::size_t width = count.distributions.size();
  for (std::size_t t = 0; t < results.converged.size(); ++t) {
    if (!results.converged[t]) {
      ++count.not_converged;
      count.not_converged_first.push_back(results.first + static_cast<std::int64_t>(t));
      continue;
    }
    for (std::size_t i = 0; i < width; ++i) {
      count.distributions[i].add(results.values[t * width + i]);
    }
  }
}

void keep_the_first(std::vector<std::int64_t>& trials) {
  std::sort(trials.begin(), trials.end());
  trials.resize(std::min(trials.size(), failures_listed));
}

Expected<void> append(MonteCarloCount& count, const MonteCarloCount& next) {
  const auto same = [](const Distribution& a, const Distribution& b) {
    return a.ruler().centre == b.ruler().centre && a.ruler().scale == b.ruler().scale;
  };
  if (next.first != count.end) {
    return wrong_usage(fmt::format("trials {} to {} do not follow those up to {}", next.first, next.end, count.end));
  }
  if (!std::equal(count.distributions.begin(), count.distributions.end(), next.distributions.begin(),
                  next.distributions.end(), same)) {
    return wrong_usage("the trials were counted by other rulers: they are not of the same recording and program");
  }
  count.end = next.end;
  count.not_converged += next.not_converged;
  count.not_converged_first.insert(count.not_converged_first.end(), next.not_converged_first.begin(),
                                   next.not_converged_first.end());
  keep_the_first(count.not_converged_first);
  for (std::size_t i = 0; i < count.distributions.size(); ++i) {
    count.distributions[i].add(next.distributions[i]);
  }
  return {};
}

}  // namespace artcal
