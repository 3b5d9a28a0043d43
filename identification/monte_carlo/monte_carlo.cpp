#include "identification/monte_carlo/monte_carlo.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include <fmt/format.h>

#include "core/parallel.h"
#include "identification/monte_carlo/trial_maker.h"

namespace artcal {
namespace {

constexpr std::int64_t pilot_trials = 200;
constexpr std::int64_t trials_a_round = 10'000;  // JCGM 101 §7.9.4 b: max(10⁴, 100/(1 − p))
constexpr std::int64_t trials_at_once = 50;      // that a thread takes
// Pilot trials are trials of this seed's own.
constexpr std::uint64_t pilot_mark = 0x9e3779b97f4a7c15ULL;

}  // namespace

MonteCarlo::MonteCarlo(std::unique_ptr<TrialMaker> maker, std::uint64_t seed) : maker_(std::move(maker)), seed_(seed) {}
MonteCarlo::MonteCarlo(MonteCarlo&&) noexcept = default;
MonteCarlo& MonteCarlo::operator=(MonteCarlo&&) noexcept = default;
MonteCarlo::~MonteCarlo() = default;

const std::vector<Measurand>& MonteCarlo::quantities() const { return maker_->quantities(); }

Expected<MonteCarlo> MonteCarlo::prepare(const Recording& recording, const Constraints& constraints,
                                         const IdentifyOptions& options, const Identification& identification,
                                         const MonteCarloOptions& monte_carlo) {
  return TrialMaker::prepare(recording, constraints, options, identification, monte_carlo)
      .map([&](std::unique_ptr<TrialMaker> maker) { return MonteCarlo(std::move(maker), monte_carlo.seed); });
}

Expected<MonteCarloCount> MonteCarlo::begin(std::int64_t first) const {
  TrialMaker::Scratch scratch = maker_->scratch();
  const TrialResults pilot = maker_->make(seed_ ^ pilot_mark, 0, pilot_trials, scratch);
  const std::size_t width = quantities().size();
  MonteCarloCount count{first, first, 0, {}, {}};
  for (std::size_t i = 0; i < width; ++i) {
    double sum = 0.0;
    double squares = 0.0;
    int converged = 0;
    const double from = quantities()[i].estimate;
    for (std::size_t t = 0; t < pilot.converged.size(); ++t) {
      if (pilot.converged[t]) {
        const double off = pilot.values[t * width + i] - from;
        sum += off;
        squares += off * off;
        ++converged;
      }
    }
    if (converged < pilot_trials / 2) {
      return no_solution(fmt::format(
          "only {} of {} identifications from readings drawn anew converged, to an arm that measures: these readings "
          "hardly determine the arm; fix (--hold) the parameters that `artcal coupling` calls weak",
          converged, pilot_trials));
    }
    const double mean = sum / converged;
    const double deviation = std::sqrt(std::max(0.0, squares / converged - mean * mean));
    // What does not vary has a ruler too: 1e-12 mm, or what moves the tip by that.
    count.distributions.emplace_back(Ruler{from + mean, std::max(deviation, 1e-12 * maker_->natural_unit(i))});
  }
  return count;
}

Expected<void> MonteCarlo::run(MonteCarloCount& count, const TrialsWanted& wanted, const MonteCarloWatch& watch) const {
  const auto stopped = [&] { return watch.stop != nullptr && watch.stop->load(); };
  const std::int64_t last = wanted.number.value_or(count.first + max_trials);
  while (count.end < last && !stopped()) {
    // Rounds end at the same trials whatever was done before, so that decisions do not depend on it.
    const std::int64_t round_end = std::min(last, (count.end / trials_a_round + 1) * trials_a_round);
    std::atomic<std::int64_t> next{count.end};
    std::mutex counting;
    const auto work = [&] {
      TrialMaker::Scratch scratch = maker_->scratch();
      while (!stopped()) {
        const std::int64_t first = next.fetch_add(trials_at_once);
        if (first >= round_end) {
          break;
        }
        const std::int64_t size = std::min(trials_at_once, round_end - first);
        const TrialResults results = maker_->make(seed_, first, size, scratch);
        const std::lock_guard lock(counting);
        add_results(results, count);
        count.end += size;
        if (watch.progress) {
          watch.progress(count);
        }
      }
    };
    on_threads(thread_count(watch.threads, static_cast<std::size_t>(round_end - count.end)), work);
    keep_the_first(count.not_converged_first);
    if (watch.round_done) {
      watch.round_done(count);
    }
    const std::int64_t made = count.end - count.first;
    if (made >= 100 && 100 * count.not_converged > made) {
      return no_solution(fmt::format(
          "{} of {} identifications from readings drawn anew did not converge, or not to an arm that finds balls by "
          "points on them (trials {}, …), more than one in a hundred: what the others say would be too good; hold the "
          "parameters that `artcal coupling` calls weak",
          count.not_converged, made, count.not_converged_first.front()));
    }
    if (!wanted.number && count.end == round_end && !stopped()) {
      const auto results = summary(quantities(), count, wanted.digits);
      if (std::all_of(results.begin(), results.end(), [](const auto& result) { return result.stable; })) {
        return {};
      }
    }
  }
  if (!wanted.number && !stopped()) {
    return no_solution(
        fmt::format("{} trials do not make every quantity stable to {} digits; ask for a number of trials", max_trials,
                    wanted.digits));
  }
  return {};
}

}  // namespace artcal
