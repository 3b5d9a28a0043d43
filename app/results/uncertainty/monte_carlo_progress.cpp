#include "app/results/uncertainty/monte_carlo_progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

namespace artcal {
namespace {

using namespace std::chrono_literals;

std::string duration(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

MonteCarloProgress::MonteCarloProgress(const std::vector<Measurand>& quantities, const TrialsWanted& wanted,
                                       std::int64_t begun_at)
    : quantities_(quantities), wanted_(wanted), begun_at_(begun_at), terminal_(::isatty(STDERR_FILENO) == 1) {}

MonteCarloProgress::~MonteCarloProgress() {
  if (line_open_) {
    std::fputc('\n', stderr);
  }
}

// Tolerances shrink with the root of the number of trials.
double MonteCarloProgress::trials_needed(const MonteCarloCount& count) const {
  if (wanted_.number) {
    return static_cast<double>(*wanted_.number);
  }
  const double made = static_cast<double>(count.end - count.first);
  double factor = 0.0;
  for (const MonteCarloSummary& result : summary(quantities_, count, wanted_.digits)) {
    factor = std::max(factor, std::pow(result.tolerance / result.tolerance_wanted, 2));
  }
  return static_cast<double>(count.first) + made * factor;
}

void MonteCarloProgress::tell(const MonteCarloCount& count) {
  const auto now = Clock::now();
  if (now - told_ < (terminal_ ? 1s : 10s) || count.end - count.first < 2) {
    return;
  }
  told_ = now;
  const double rate = static_cast<double>(count.end - begun_at_) / std::chrono::duration<double>(now - start_).count();
  const double left = std::max(0.0, trials_needed(count) - static_cast<double>(count.end));
  const std::string line = fmt::format("{} trials, {:.0f} a second, {}{} left", count.end, rate,
                                       wanted_.number ? "" : "about ", duration(left / std::max(rate, 1e-9)));
  fmt::print(stderr, "{}{:<60}{}", terminal_ ? "\r" : "", line, terminal_ ? "" : "\n");
  std::fflush(stderr);
  line_open_ = terminal_;
}

}  // namespace artcal
