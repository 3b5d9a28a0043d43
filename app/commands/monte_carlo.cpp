#include "app/commands/monte_carlo.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>

#include "app/output/capture.h"
#include "app/output/output.h"
#include "app/output/stop_on_signal.h"
#include "app/requests/recording_request.h"
#include "app/requests/referenced_files.h"
#include "app/results/identification/input_warnings.h"
#include "app/results/uncertainty/monte_carlo_progress.h"
#include "app/results/uncertainty/monte_carlo_result.h"
#include "app/results/uncertainty/monte_carlo_state.h"

namespace artcal {
namespace {

constexpr std::chrono::seconds between_states{30};

/// What trials are made of. Where it is stays, for a MonteCarlo refers to it.
struct Material {
  Recording recording;
  Constraints constraints;
  IdentifyOptions options;
  MonteCarloOptions monte_carlo;
  Identification identification;
};

const std::string& state_of(const MonteCarloRequest& request) {
  return request.state.empty() ? request.resume : request.state;
}

Expected<std::unique_ptr<Material>> identify_once(const MonteCarloRequest& request, const CommonOptions& common,
                                                  const std::string& path, const std::string& probe,
                                                  std::uint64_t seed) {
  const RecordingRequest of_recording{path, request.access};
  auto bound = of_recording.read_bound();
  if (!bound) {
    return tl::unexpected(bound.error());
  }
  auto& [recording, constraints] = *bound;
  auto options = request.choices.options(recording);
  if (!options) {
    return tl::unexpected(options.error());
  }
  options->leave_out = options->automatic;  // which chooses by it
  auto monte_carlo = request.options(recording.arm, probe, seed);
  if (!monte_carlo) {
    return tl::unexpected(monte_carlo.error());
  }
  std::vector<InputFile> inputs = referenced_files(recording, of_recording.access());
  for (const std::string& shard : request.merge) {
    inputs.push_back({shard, ""});
  }
  if (auto checked = check_outputs({common.json, state_of(request)}, inputs); !checked) {
    return tl::unexpected(checked.error());
  }
  auto identification = with_input_warnings(identify(recording, constraints, *options), recording, constraints);
  if (!identification) {
    return tl::unexpected(identification.error());
  }
  return std::make_unique<Material>(Material{std::move(recording), std::move(constraints), std::move(*options),
                                             std::move(*monte_carlo), std::move(*identification)});
}

/// What was counted before: a state to go on from, shards to put together, or nothing.
Expected<MonteCarloCount> earlier_count(const MonteCarloRequest& request, const TrialRange& range, MonteCarloCount none,
                                        const nlohmann::ordered_json& made_from) {
  std::vector<std::string> paths = request.merge;
  if (!request.resume.empty()) {
    paths.push_back(request.resume);
  }
  std::vector<MonteCarloCount> parts;
  for (const std::string& path : paths) {
    auto part = read_state(path, made_from);
    if (!part) {
      return tl::unexpected(part.error());
    }
    parts.push_back(std::move(*part));
  }
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const MonteCarloCount& part : parts) {
    if (auto appended = append(none, part); !appended) {
      return bad_input(appended.error().message, request.resume.empty() ? "--merge" : request.resume);
    }
  }
  if (range.wanted.number && none.end > *range.wanted.number) {
    return wrong_usage(
        fmt::format("{} trials are made already, more than the {} asked for", none.end, *range.wanted.number));
  }
  if (!request.merge.empty() && none.end != *range.wanted.number) {
    return bad_input(fmt::format("the shards hold trials up to {}, but {} were asked for: one is missing", none.end,
                                 *range.wanted.number),
                     "--merge");
  }
  return none;
}

/// Where counts are kept, if anywhere.
struct StateFile {
  const std::string& path;
  const nlohmann::ordered_json& made_from;

  [[nodiscard]] Expected<void> write(const MonteCarloCount& count) const {
    return path.empty() ? Expected<void>() : write_file(path, state_text(count, made_from));
  }
};

Expected<void> make_trials(const MonteCarlo& monte_carlo, const TrialsWanted& wanted, int threads, bool quiet,
                           const StateFile& state, const std::atomic<bool>& stop, MonteCarloCount& count) {
  // Before the work, not after it: a file that cannot be written.
  if (auto kept = state.write(count); !kept) {
    return kept;
  }
  Expected<void> run;
  {
    MonteCarloProgress progress(monte_carlo.quantities(), wanted, count.end);
    auto written = std::chrono::steady_clock::now();
    Capture* const caller = current_capture();
    const MonteCarloWatch watch{[&](const MonteCarloCount& now) {
                                  if (Capture* const capture = caller; capture != nullptr && capture->progress) {
                                    capture->progress("Monte Carlo trials", static_cast<std::size_t>(now.end),
                                                      static_cast<std::size_t>(wanted.number.value_or(0)));
                                  } else if (!quiet) {
                                    progress.tell(now);
                                  }
                                },
                                [&](const MonteCarloCount& now) {
                                  if (std::chrono::steady_clock::now() - written > between_states) {
                                    (void)state.write(now);  // the last one tells what is wrong
                                    written = std::chrono::steady_clock::now();
                                  }
                                },
                                &stop, threads};
    run = monte_carlo.run(count, wanted, watch);
  }
  if (auto kept = state.write(count); !kept) {
    return kept;
  }
  if (run && count.end - count.first - count.not_converged < 2) {
    return no_solution("stopped before there were two trials");
  }
  return run;
}

Expected<void> tell(const MonteCarloResult& result, const CommonOptions& common, const std::string& state) {
  if (auto told = write_json(common.json, to_json(result)); !told) {
    return told;
  }
  std::string text = to_text(result);
  if (!state.empty()) {
    text += fmt::format("Trials {} to {} are counted in {}.\n", result.count.first + 1, result.count.end, state);
  }
  common.say(text);
  return {};
}

}  // namespace

Expected<int> monte_carlo_and_tell(const MonteCarloRequest& request, const CommonOptions& common,
                                   const std::string& recording, const std::string& probe, std::uint64_t seed) {
  const auto range = request.range();
  if (!range) {
    return tl::unexpected(range.error());
  }
  const auto material = identify_once(request, common, recording, probe, seed);
  if (!material) {
    return tl::unexpected(material.error());
  }
  const Material& made = **material;
  const auto monte_carlo =
      MonteCarlo::prepare(made.recording, made.constraints, made.options, made.identification, made.monte_carlo);
  if (!monte_carlo) {
    return tl::unexpected(monte_carlo.error());
  }
  const auto made_from = made_from_json(made.recording, made.options, made.identification, made.monte_carlo);
  auto count = monte_carlo->begin(range->first).and_then([&](MonteCarloCount&& none) {
    return earlier_count(request, *range, std::move(none), made_from);
  });
  if (!count) {
    return tl::unexpected(count.error());
  }
  const StopOnSignal signal;
  const StateFile state{state_of(request), made_from};
  if (auto run = make_trials(*monte_carlo, range->wanted, request.threads, common.quiet, state, signal.stop(), *count);
      !run) {
    return tl::unexpected(run.error());
  }
  const bool complete = !signal.stop().load();
  const MonteCarloResult result{made.recording,   made.options,  made.identification,
                                made.monte_carlo, range->wanted, monte_carlo->quantities(),
                                *count,           complete};
  if (auto told = tell(result, common, state.path); !told) {
    return tl::unexpected(told.error());
  }
  return complete ? 0 : interrupted;
}

}  // namespace artcal
