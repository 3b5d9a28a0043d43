#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "identification/identify.h"
#include "identification/monte_carlo/monte_carlo_count.h"
#include "identification/monte_carlo/monte_carlo_summary.h"
#include "identification/monte_carlo/simulated_measurement.h"

namespace artcal {

/// What is drawn beside the noise that the identification knows or found, and what is followed.
struct MonteCarloOptions {
  std::uint64_t seed = 1;
  double u_temperature = 0.0;      ///< of an artefact's temperature in a placement, K
  double u_arm_temperature = 0.0;  ///< of the arm's in a placement, K; for arms that expand
  MeasuringRequest measuring;
};

/// How many trials are wanted.
struct TrialsWanted {
  std::optional<std::int64_t> number;  ///< up to this trial; else until `digits` stand (JCGM 101 §7.9)
  int digits = 2;                      ///< significant decimal digits of u, 1 or 2
};
inline constexpr std::int64_t max_trials = 100'000'000;

/// How a run may be watched and stopped. The functions may be empty.
struct MonteCarloWatch {
  std::function<void(const MonteCarloCount&)> progress;    ///< every 50 trials, from any thread, one at a time
  std::function<void(const MonteCarloCount&)> round_done;  ///< every 10,000: the count is whole and may be kept
  const std::atomic<bool>* stop = nullptr;                 ///< trials that have begun are finished
  int threads = 0;                                         ///< 0 takes all; the counts do not depend on it
};

class TrialMaker;

/// Propagation of distributions (JCGM 101) through a whole identification. Each trial draws readings and certificates
/// anew (normal: noise of the readings, standard uncertainties of certified lengths, radii, coordinates and expansion),
/// identifies the arm from them by full non-linear least squares, and has that arm measure. Which parameters are free,
/// the weights and the loss are those of the identification. Where the noise was estimated, each trial draws it too, by
/// its degrees of freedom; where uncertainties were enlarged, the draws are.
///
/// Trial t is known by (seed, t) alone: neither threads nor machines nor the order change a digit.
class MonteCarlo {
 public:
  /// `recording` and `constraints` must outlive this. Bad input: a point to be measured that the arm does not reach; an
  /// uncertainty of the arm's temperature where nothing of the arm depends on it.
  /// No solution: the readings agree to the last digits, so that there is no noise to draw; see fit_arm().
  static Expected<MonteCarlo> prepare(const Recording& recording, const Constraints& constraints,
                                      const IdentifyOptions& options, const Identification& identification,
                                      const MonteCarloOptions& monte_carlo);
  MonteCarlo(MonteCarlo&&) noexcept;
  MonteCarlo& operator=(MonteCarlo&&) noexcept;
  ~MonteCarlo();

  [[nodiscard]] const std::vector<Measurand>& quantities() const;

  /// No trials yet, the next being `first`. The histograms are laid by 200 trials of a stream of their own.
  [[nodiscard]] Expected<MonteCarloCount> begin(std::int64_t first = 0) const;

  /// Goes on until enough trials are made or the watch stops it. No solution: more than one trial in a hundred did not
  /// converge (from 100 trials on, after each round), or, unless a number is wanted, `most_trials` were not enough.
  Expected<void> run(MonteCarloCount& count, const TrialsWanted& wanted, const MonteCarloWatch& watch) const;

 private:
  MonteCarlo(std::unique_ptr<TrialMaker> maker, std::uint64_t seed);
  std::unique_ptr<TrialMaker> maker_;
  std::uint64_t seed_;
};

}  // namespace artcal
