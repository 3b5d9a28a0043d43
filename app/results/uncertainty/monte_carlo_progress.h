#pragma once

#include <chrono>
#include <string>

#include "identification/monte_carlo/monte_carlo.h"

namespace artcal {

/// Tells how far a Monte Carlo is, on standard error: on a terminal one line that changes, in a log a plain line every
/// ten seconds.
class MonteCarloProgress {
 public:
  MonteCarloProgress(const std::vector<Measurand>& quantities, const TrialsWanted& wanted, std::int64_t begun_at);
  ~MonteCarloProgress();
  MonteCarloProgress(const MonteCarloProgress&) = delete;
  MonteCarloProgress& operator=(const MonteCarloProgress&) = delete;

  void tell(const MonteCarloCount& count);

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double trials_needed(const MonteCarloCount& count) const;

  const std::vector<Measurand>& quantities_;
  TrialsWanted wanted_;
  std::int64_t begun_at_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point told_ = start_;
  bool terminal_;
  bool line_open_ = false;
};

}  // namespace artcal
