#include "app/command_monte_carlo.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "acquisition/recording_file.h"
#include "app/identification_run.h"
#include "app/monte_carlo_progress.h"
#include "app/monte_carlo_result.h"
#include "app/monte_carlo_state.h"
#include "app/output.h"
#include "artefacts/constraint.h"
#include "core/in_quotes.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr const char* group = "Monte Carlo";
constexpr int interrupted = 130;  // as shells have it: 128 + SIGINT
constexpr std::chrono::seconds between_states{30};

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// Trials that this run makes.
struct Range {
  std::int64_t first = 0;
  TrialsWanted wanted;
};

Expected<Range> range_of(const MonteCarloRequest& request) {
  Range range{0, {std::nullopt, request.digits}};
  if (request.trials != "auto") {
    range.wanted.number = whole_number(request.trials);
    if (!range.wanted.number || *range.wanted.number < 2 || *range.wanted.number > most_trials) {
      return wrong_usage(fmt::format("--trials is {}, expected a number from 2 to {}, or auto",
                                     in_quotes(request.trials), most_trials));
    }
  }
  if (request.shard.empty()) {
    return range;
  }
  const auto slash = request.shard.find('/');
  const auto part_of = [&](std::size_t from, std::size_t length) {
    return whole_number(std::string_view(request.shard).substr(from, length)).value_or(0);
  };
  const std::int64_t k = part_of(0, slash);
  const std::int64_t n = slash == std::string::npos ? 0 : part_of(slash + 1, std::string::npos);
  if (k < 1 || n < k || n > 10'000) {
    return wrong_usage(fmt::format("--shard is {}, expected which of how many, such as 2/4", in_quotes(request.shard)));
  }
  if (!range.wanted.number || request.state.empty()) {
    return wrong_usage("--shard needs --trials with a number, of all shards together, and --state FILE to write");
  }
  const std::int64_t all = *range.wanted.number;
  range.first = all * (k - 1) / n;
  range.wanted.number = all * k / n;
  return range;
}

Expected<std::vector<Eigen::Vector3d>> points_of(const MonteCarloRequest& request) {
  std::vector<Eigen::Vector3d> points;
  for (const std::string& text : request.points) {
    std::array<double, 3> xyz{};
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    bool read = true;
    for (std::size_t i = 0; i < 3 && read; ++i) {
      const auto [next, error] = std::from_chars(at, end, xyz[i]);
      read = error == std::errc() && std::isfinite(xyz[i]) && (i == 2 ? next == end : next != end && *next == ',');
      at = next + 1;
    }
    if (!read) {
      return wrong_usage(
          fmt::format("--at is {}, expected coordinates in the base frame in mm, such as 600,0,450", in_quotes(text)));
    }
    points.emplace_back(xyz[0], xyz[1], xyz[2]);
  }
  return points;
}

Expected<MonteCarloOptions> options_of(const MonteCarloRequest& request, const Arm& arm, const std::string& probe,
                                       std::uint64_t seed) {
  MonteCarloOptions options;
  options.seed = seed;
  options.measuring.seed = seed;
  if (!request.u_temperature.empty()) {
    const auto u = temperature_difference(request.u_temperature);
    if (!u || *u < 0.0) {
      return wrong_usage(fmt::format("--u-temperature is {}, expected a standard uncertainty such as \"0.1 K\"",
                                     in_quotes(request.u_temperature)));
    }
    options.u_temperature = *u;
  }
  options.measuring.probe = probe.empty() ? 0 : probe_index(arm, probe);
  if (options.measuring.probe < 0) {
    return wrong_usage(fmt::format("the arm has no probe {}", in_quotes(probe)));
  }
  return points_of(request).map([&](auto points) {
    options.measuring.points_in_base = std::move(points);
    return options;
  });
}

/// What was counted before: a state to go on from, shards to put together, or nothing.
Expected<MonteCarloCount> earlier_count(const MonteCarloRequest& request, const Range& range, MonteCarloCount none,
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
  return none;
}

Expected<void> check_request(const MonteCarloRequest& request) {
  if (!request.merge.empty() && (!request.resume.empty() || !request.shard.empty() || request.trials == "auto")) {
    return wrong_usage(
        "--merge goes with --trials, the number of all shards together, and without --resume and --shard");
  }
  return {};
}

}  // namespace

void MonteCarloRequest::add_to(CLI::App& parser) {
  CLI::Option* flag =
      parser.add_flag("--monte-carlo", asked,
                      "of a RECORDING: identify again and again from readings and certificates drawn anew (JCGM 101)");
  parser.add_option("--trials", trials, "how many; auto: until u stands to its digits")
      ->group(group)
      ->type_name("N|auto");
  parser.add_option("--digits", digits, "of u that are to stand")->check(CLI::Range(1, 2))->group(group);
  parser.add_option("--threads", threads, "0 takes all; the result is the same")
      ->check(CLI::NonNegativeNumber)
      ->group(group);
  parser.add_option("--at", points, "a point to measure, mm in the base frame, such as 600,0,450; may be repeated")
      ->type_name("X,Y,Z")
      ->group(group);
  parser.add_option("--u-temperature", u_temperature, "standard uncertainty of temperatures, such as \"0.1 K\"")
      ->group(group);
  parser.add_option("--state", state, "write what is counted, also on Ctrl-C, to go on from")
      ->type_name("FILE")
      ->group(group);
  parser.add_option("--resume", resume, "go on from such a file, and write it")->type_name("FILE")->group(group);
  parser.add_option("--shard", shard, "make one part of the trials, such as 2/4, for --merge")
      ->type_name("K/N")
      ->group(group);
  parser.add_option("--merge", merge, "put the states of all shards together")
      ->delimiter(',')
      ->type_name("FILES")
      ->group(group);
  choices.add_to(parser, group);
  for (CLI::Option* option : parser.get_options([](const CLI::Option* o) { return o->get_group() == group; })) {
    option->needs(flag);
  }
  flag->group(group);
}

Expected<int> monte_carlo_and_tell(const MonteCarloRequest& request, const CommonOptions& common,
                                   const std::string& recording_path, const std::string& probe, std::uint64_t seed) {
  if (auto sound = check_request(request); !sound) {
    return tl::unexpected(sound.error());
  }
  const auto range = range_of(request);
  if (!range) {
    return tl::unexpected(range.error());
  }
  auto recording = read_recording(recording_path);
  if (!recording) {
    return tl::unexpected(recording.error());
  }
  const auto constraints = read_constraints(*recording);
  if (!constraints) {
    return tl::unexpected(constraints.error());
  }
  auto options = request.choices.options(*recording);
  if (!options) {
    return tl::unexpected(options.error());
  }
  options->leave_out = options->automatic;  // which chooses by it
  const auto monte_carlo_options = options_of(request, recording->arm, probe, seed);
  if (!monte_carlo_options) {
    return tl::unexpected(monte_carlo_options.error());
  }
  const std::string& state = request.state.empty() ? request.resume : request.state;
  if (auto checked = check_outputs({common.json, state}, recording->inputs); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto identification = run_identification(*recording, *constraints, *options);
  if (!identification) {
    return tl::unexpected(identification.error());
  }
  const auto monte_carlo =
      MonteCarlo::prepare(*recording, *constraints, *options, *identification, *monte_carlo_options);
  if (!monte_carlo) {
    return tl::unexpected(monte_carlo.error());
  }
  auto begun = monte_carlo->begin(range->first);
  if (!begun) {
    return tl::unexpected(begun.error());
  }
  const auto made_from = made_from_json(*recording, *options, *identification, *monte_carlo_options);
  auto count = earlier_count(request, *range, std::move(*begun), made_from);
  if (!count) {
    return tl::unexpected(count.error());
  }
  if (!request.merge.empty() && count->end != *range->wanted.number) {
    return bad_input(fmt::format("the shards hold trials up to {}, but {} were asked for: one is missing", count->end,
                                 *range->wanted.number),
                     "--merge");
  }
  const auto write_state = [&]() -> Expected<void> {
    return state.empty() ? Expected<void>() : write_file(state, state_text(*count, made_from));
  };
  auto written = std::chrono::steady_clock::now();
  const StopOnSignal signal;
  // Before the work, not after it: a file that cannot be written.
  if (auto kept = write_state(); !kept) {
    return tl::unexpected(kept.error());
  }
  Expected<void> run;
  {
    MonteCarloProgress progress(monte_carlo->quantities(), range->wanted, count->end);
    const MonteCarloWatch watch{[&](const MonteCarloCount& now) {
                                  if (!common.quiet) {
                                    progress.tell(now);
                                  }
                                },
                                [&](const MonteCarloCount&) {
                                  if (std::chrono::steady_clock::now() - written > between_states) {
                                    (void)write_state();  // the last one tells what is wrong
                                    written = std::chrono::steady_clock::now();
                                  }
                                },
                                &signal.stop(), request.threads};
    run = monte_carlo->run(*count, range->wanted, watch);
  }
  if (auto kept = write_state(); !kept) {
    return tl::unexpected(kept.error());
  }
  if (!run) {
    return tl::unexpected(run.error());
  }
  if (count->end - count->first - count->not_converged < 2) {
    return no_solution("stopped before there were two trials");
  }
  const bool complete = !signal.stop().load();
  const MonteCarloResult result{
      *recording, *options, *identification, *monte_carlo_options, range->wanted, monte_carlo->quantities(),
      *count,     complete};
  if (auto told = write_json(common.json, to_json(result)); !told) {
    return tl::unexpected(told.error());
  }
  if (common.talks()) {
    fmt::print("{}", to_text(result));
    if (!state.empty()) {
      fmt::print("Trials {} to {} are counted in {}.\n", count->first + 1, count->end, state);
    }
  }
  return complete ? 0 : interrupted;
}

}  // namespace artcal
