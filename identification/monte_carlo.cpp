#include "identification/monte_carlo.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "identification/reidentification.h"
#include "identification/trial_inputs.h"

namespace artcal {
namespace {

constexpr std::int64_t pilot_trials = 200;
constexpr std::int64_t trials_a_round = 10'000;  // JCGM 101 §7.9.4 b: max(10⁴, 100/(1 − p))
constexpr std::int64_t trials_at_once = 50;      // that a thread takes
constexpr std::size_t failures_listed = 10;
constexpr std::size_t most_threads = 256;
constexpr double probability = 0.95;
// Pilot trials are trials of this seed's own.
constexpr std::uint64_t pilot_mark = 0x9e3779b97f4a7c15ULL;
constexpr double least_noise = 1e-8;  // mm; readings that agree better were not taken by an arm

Noise noise_in_use(const IdentifyOptions& options, const Identification& identification) {
  Noise noise = options.noise;
  if (!noise.is_given()) {
    noise.reading = identification.noise;
  }
  return noise;
}

InputSpread spread_of(const Noise& noise, const Identification& identification, double u_temperature) {
  InputSpread spread;
  spread.encoder = noise.encoder.value_or(0.0);
  spread.probing = noise.reading ? *noise.reading : *noise.probing;
  spread.temperature = u_temperature;
  spread.enlargement = identification.enlargement;
  if (!identification.noise_is_given) {
    spread.degrees_of_freedom = identification.degrees_of_freedom;
  }
  return spread;
}

/// The values of a run of trials; a row of NaN where one did not converge.
struct Results {
  std::int64_t first = 0;
  std::vector<double> values;
  std::vector<bool> converged;
};

void count_results(const Results& results, MonteCarloCount& count) {
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

}  // namespace

struct MonteCarlo::Parts {
  MonteCarloOptions options;
  ArmFit fit;
  System system;
  SolveOptions solve_options;
  InputSpread spread;
  std::optional<Reidentification> again;
  std::optional<Measuring> measuring;
  std::vector<FollowedQuantity> quantities;
  const Recording* recording = nullptr;

  [[nodiscard]] Results make(std::uint64_t seed, std::int64_t first, std::int64_t count, TrialInputs& inputs,
                             Reidentification::Scratch& scratch) const;
};

Results MonteCarlo::Parts::make(std::uint64_t seed, std::int64_t first, std::int64_t count, TrialInputs& inputs,
                                Reidentification::Scratch& scratch) const {
  Results results{first, {}, {}};
  const std::size_t width = quantities.size();
  results.values.resize(width * static_cast<std::size_t>(count));
  for (std::int64_t t = 0; t < count; ++t) {
    const auto trial = static_cast<std::uint64_t>(first + t);
    double* values = results.values.data() + width * static_cast<std::size_t>(t);
    inputs.draw(seed, trial);
    const Reidentification::Answer answer = again->solve(inputs.system(), scratch);
    if (answer.converged) {
      const Arm arm = system.arm_at(answer.x.data());
      for (const Parameter& parameter : system.free) {
        *values++ = value(arm, parameter);
      }
      RandomStream random(seed, "trial: measuring", trial);
      measuring->measure(arm, random, values);
    }
    const double* row = results.values.data() + width * static_cast<std::size_t>(t);
    results.converged.push_back(answer.converged &&
                                std::all_of(row, row + width, [](double number) { return std::isfinite(number); }));
  }
  return results;
}

MonteCarlo::MonteCarlo(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MonteCarlo::MonteCarlo(MonteCarlo&&) noexcept = default;
MonteCarlo& MonteCarlo::operator=(MonteCarlo&&) noexcept = default;
MonteCarlo::~MonteCarlo() = default;

const std::vector<FollowedQuantity>& MonteCarlo::quantities() const { return parts_->quantities; }

Expected<MonteCarlo> MonteCarlo::prepare(const Recording& recording, const Constraints& constraints,
                                         const IdentifyOptions& options, const Identification& identification,
                                         const MonteCarloOptions& monte_carlo) {
  const Noise noise = noise_in_use(options, identification);
  if (noise.reading.value_or(1.0) < least_noise) {
    return no_solution(
        "the readings agree to the last digits, so that there is no noise to draw from; state one, such as --noise "
        "\"15 um\"");
  }
  auto parts = std::make_unique<Parts>();
  parts->options = monte_carlo;
  parts->solve_options = {options.loss, options.max_iterations};
  parts->recording = &recording;
  std::vector<Parameter> free;
  for (const int index : identification.free) {
    free.push_back(identification.parameters[index].parameter);
  }
  auto fit = fit_arm(recording, constraints, identification.arm, free, noise, parts->solve_options);
  if (!fit) {
    return tl::unexpected(fit.error());
  }
  parts->fit = std::move(*fit);
  parts->system = make_system(recording, constraints, parts->fit.arm, free);
  parts->spread = spread_of(noise, identification, monte_carlo.u_temperature);
  auto again = Reidentification::of(parts->system, parts->fit, parts->solve_options);
  if (!again) {
    return tl::unexpected(again.error());
  }
  parts->again = std::move(*again);
  auto plan = plan_measuring(parts->fit.arm, monte_carlo.measuring);
  if (!plan) {
    return tl::unexpected(plan.error());
  }
  const double encoder = parts->spread.enlargement * parts->spread.encoder;
  const double probing = parts->spread.enlargement * parts->spread.probing;
  const UncertainArm uncertain(parts->fit.arm, {free, identification.covariance, encoder, probing}, plan->probe);
  parts->measuring.emplace(std::move(*plan), uncertain, encoder, probing);
  for (const int index : identification.free) {
    const IdentifiedParameter& known = identification.parameters[index];
    parts->quantities.push_back({FollowedQuantity::Kind::Parameter, known.parameter.name, known.parameter.unit(),
                                 value(parts->fit.arm, known.parameter), known.u});
  }
  const auto& measured = parts->measuring->quantities();
  parts->quantities.insert(parts->quantities.end(), measured.begin(), measured.end());
  return MonteCarlo(std::move(parts));
}

Expected<MonteCarloCount> MonteCarlo::begin(std::int64_t first) const {
  TrialInputs inputs(parts_->system, *parts_->recording, parts_->spread);
  Reidentification::Scratch scratch = parts_->again->scratch();
  const Results pilot = parts_->make(parts_->options.seed ^ pilot_mark, 0, pilot_trials, inputs, scratch);
  const std::size_t width = parts_->quantities.size();
  MonteCarloCount count{first, first, 0, {}, {}};
  for (std::size_t i = 0; i < width; ++i) {
    double sum = 0.0;
    double squares = 0.0;
    int converged = 0;
    const double from = parts_->quantities[i].estimate;
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
          "only {} of {} identifications from readings drawn anew converged: these readings hardly determine the arm; "
          "hold the parameters that `artcal coupling` calls weak",
          converged, pilot_trials));
    }
    const double mean = sum / converged;
    const double deviation = std::sqrt(std::max(0.0, squares / converged - mean * mean));
    // What does not vary has a ruler too: 1e-12 mm, or what moves the tip by that.
    const double unit = i < parts_->system.free.size() ? parts_->system.scale[static_cast<Eigen::Index>(i)] : 1.0;
    count.distributions.emplace_back(Ruler{from + mean, std::max(deviation, 1e-12 * unit)});
  }
  return count;
}

Expected<void> MonteCarlo::run(MonteCarloCount& count, const TrialsWanted& wanted, const MonteCarloWatch& watch) const {
  const auto stopped = [&] { return watch.stop != nullptr && watch.stop->load(); };
  const std::int64_t last = wanted.number.value_or(count.first + most_trials);
  const auto threads =
      std::min(most_threads, watch.threads > 0 ? static_cast<std::size_t>(watch.threads)
                                               : std::max<std::size_t>(1, std::thread::hardware_concurrency()));
  while (count.end < last && !stopped()) {
    // Rounds end at the same trials whatever was done before, so that decisions do not depend on it.
    const std::int64_t round_end = std::min(last, (count.end / trials_a_round + 1) * trials_a_round);
    std::atomic<std::int64_t> next{count.end};
    std::mutex counting;
    const auto work = [&] {
      TrialInputs inputs(parts_->system, *parts_->recording, parts_->spread);
      Reidentification::Scratch scratch = parts_->again->scratch();
      while (!stopped()) {
        const std::int64_t first = next.fetch_add(trials_at_once);
        if (first >= round_end) {
          break;
        }
        const std::int64_t size = std::min(trials_at_once, round_end - first);
        const Results results = parts_->make(parts_->options.seed, first, size, inputs, scratch);
        const std::lock_guard lock(counting);
        count_results(results, count);
        count.end += size;
        if (watch.progress) {
          watch.progress(count);
        }
      }
    };
    std::vector<std::future<void>> others;
    while (others.size() + 1 < threads) {
      others.push_back(std::async(std::launch::async, work));
    }
    work();
    for (auto& other : others) {
      other.get();
    }
    keep_the_first(count.not_converged_first);
    if (watch.round_done) {
      watch.round_done(count);
    }
    const std::int64_t made = count.end - count.first;
    if (made >= 100 && 100 * count.not_converged > made) {
      return no_solution(fmt::format(
          "{} of {} identifications from readings drawn anew did not converge (trials {}, …), more than one in a "
          "hundred: what the others say would be too good; hold the parameters that `artcal coupling` calls weak",
          count.not_converged, made, count.not_converged_first.front()));
    }
    if (!wanted.number && count.end == round_end && !stopped()) {
      const auto results = summary(parts_->quantities, count, wanted.digits);
      if (std::all_of(results.begin(), results.end(), [](const auto& result) { return result.stands; })) {
        return {};
      }
    }
  }
  if (!wanted.number && !stopped()) {
    return no_solution(
        fmt::format("{} trials do not make every quantity stand to {} digits; ask for a number of trials", most_trials,
                    wanted.digits));
  }
  return {};
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

std::vector<PropagatedQuantity> summary(const std::vector<FollowedQuantity>& quantities, const MonteCarloCount& count,
                                        int digits) {
  std::vector<PropagatedQuantity> all;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const Distribution& distribution = count.distributions[i];
    PropagatedQuantity result;
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
    result.stands = low && high && result.tolerance <= result.tolerance_wanted;
    const auto& linear = quantities[i].u_linear;
    result.differs_from_linear = linear && *linear > 0.0 && std::abs(result.u / *linear - 1.0) > 0.1;
    all.push_back(result);
  }
  return all;
}

}  // namespace artcal
