#include "app/requests/monte_carlo_request.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr const char* group = "Monte Carlo";

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

Expected<std::vector<Eigen::Vector3d>> points_of(const std::vector<std::string>& texts) {
  std::vector<Eigen::Vector3d> points;
  for (const std::string& text : texts) {
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

}  // namespace

void MonteCarloRequest::add_to(CLI::App& parser) {
  CLI::Option* flag =
      parser.add_flag("--monte-carlo", asked,
                      "of a RECORDING: identify again and again from readings and certificates drawn anew (JCGM 101)");
  parser.add_option("--trials", trials, "how many; auto: until u is stable to its digits")
      ->group(group)
      ->type_name("N|auto");
  parser.add_option("--digits", digits, "of u that are to be stable")->check(CLI::Range(1, 2))->group(group);
  parser.add_option("--threads", threads, "0 takes all; the result is the same")
      ->check(CLI::NonNegativeNumber)
      ->group(group);
  parser.add_option("--at", points, "a point to measure, mm in the base frame, such as 600,0,450; may be repeated")
      ->type_name("X,Y,Z")
      ->group(group);
  parser
      .add_option("--u-temperature", u_temperature,
                  "standard uncertainty of the artefacts' temperatures, such as \"0.1 K\"")
      ->group(group);
  parser.add_option("--u-arm-temperature", u_arm_temperature, "of the arm's, for an arm whose links expand")
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

Expected<TrialRange> MonteCarloRequest::range() const {
  if (!merge.empty() && (!resume.empty() || !shard.empty() || trials == "auto")) {
    return wrong_usage(
        "--merge goes with --trials, the number of all shards together, and without --resume and --shard");
  }
  TrialRange range{0, {std::nullopt, digits}};
  if (trials != "auto") {
    range.wanted.number = whole_number(trials);
    if (!range.wanted.number || *range.wanted.number < 2 || *range.wanted.number > max_trials) {
      return wrong_usage(
          fmt::format("--trials is {}, expected a number from 2 to {}, or auto", in_quotes(trials), max_trials));
    }
  }
  if (shard.empty()) {
    return range;
  }
  const auto slash = shard.find('/');
  const auto part_of = [&](std::size_t from, std::size_t length) {
    return whole_number(std::string_view(shard).substr(from, length)).value_or(0);
  };
  const std::int64_t k = part_of(0, slash);
  const std::int64_t n = slash == std::string::npos ? 0 : part_of(slash + 1, std::string::npos);
  if (k < 1 || n < k || n > 10'000) {
    return wrong_usage(fmt::format("--shard is {}, expected which of how many, such as 2/4", in_quotes(shard)));
  }
  if (!range.wanted.number || state.empty()) {
    return wrong_usage("--shard needs --trials with a number, of all shards together, and --state FILE to write");
  }
  const std::int64_t all = *range.wanted.number;
  range.first = all * (k - 1) / n;
  range.wanted.number = all * k / n;
  return range;
}

Expected<MonteCarloOptions> MonteCarloRequest::options(const Arm& arm, const std::string& probe,
                                                       std::uint64_t seed) const {
  MonteCarloOptions options;
  options.seed = seed;
  options.measuring.seed = seed;
  for (const auto& [name, text, u] :
       {std::tuple("--u-temperature", &u_temperature, &options.u_temperature),
        std::tuple("--u-arm-temperature", &u_arm_temperature, &options.u_arm_temperature)}) {
    if (!text->empty()) {
      const auto stated = temperature_difference(*text);
      if (!stated || *stated < 0.0) {
        return wrong_usage(
            fmt::format("{} is {}, expected a standard uncertainty such as \"0.1 K\"", name, in_quotes(*text)));
      }
      *u = *stated;
    }
  }
  options.measuring.probe = probe.empty() ? 0 : probe_index(arm, probe);
  if (options.measuring.probe < 0) {
    return wrong_usage(fmt::format("the arm has no probe {}", in_quotes(probe)));
  }
  return points_of(points).map([&](auto places) {
    options.measuring.points_in_base = std::move(places);
    return options;
  });
}

}  // namespace artcal
