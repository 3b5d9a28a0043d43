#include "app/results/uncertainty/monte_carlo_state.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "app/output/json_file.h"
#include "app/output/output.h"
#include "core/files/size_limits.h"
#include "core/files/text_file.h"
#include "core/text/digits.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* state_schema = "artcal-monte-carlo/1";
constexpr std::size_t max_digits = 39;  // of a 128-bit integer

std::string decimal(Distribution::Sum number) {
  std::string digits;
  const bool negative = number < 0;
  do {
    const auto digit = static_cast<int>(number % 10);
    digits.push_back(static_cast<char>('0' + (digit < 0 ? -digit : digit)));
    number /= 10;
  } while (number != 0);
  digits += negative ? "-" : "";
  std::reverse(digits.begin(), digits.end());
  return digits;
}

std::optional<Distribution::Sum> integer_of(const Json& json) {
  if (!json.is_string()) {
    return std::nullopt;
  }
  std::string digits = json.get<std::string>();
  const bool negative = digits.starts_with('-');
  digits.erase(0, negative ? 1 : 0);
  // One digit less than would fit: what is written never needs it.
  if (digits.empty() || digits.size() >= max_digits || !std::all_of(digits.begin(), digits.end(), is_digit)) {
    return std::nullopt;
  }
  Distribution::Sum number = 0;
  for (const char c : digits) {
    number = 10 * number + (c - '0');
  }
  return negative ? -number : number;
}

// Cells from the first that is not empty to the last.
Json distribution_json(const Distribution::Contents& contents) {
  const auto& counts = contents.counts;
  const auto filled = [](std::int64_t count) { return count != 0; };
  const auto first = std::find_if(counts.begin(), counts.end(), filled);
  const auto last = std::find_if(counts.rbegin(), counts.rend(), filled).base();
  return {{"centre", contents.ruler.centre},
          {"scale", contents.ruler.scale},
          {"count", contents.count},
          {"below", contents.below},
          {"above", contents.above},
          {"sum", decimal(contents.sum)},
          {"squares", decimal(contents.squares)},
          {"first_cell", first == counts.end() ? 0 : first - counts.begin()},
          {"cells", first == counts.end() ? Json::array() : Json(std::vector<std::int64_t>(first, last))}};
}

/// Reads members of an object, and remembers whether all were there and sound.
class Members {
 public:
  explicit Members(const Json& json) : json_(json), sound_(json.is_object()) {}

  std::int64_t count(const char* name) {
    const Json& found = member(name);
    sound_ = sound_ && found.is_number_integer() && found.get<std::int64_t>() >= 0 && found.get<double>() < 1e18;
    return sound_ ? found.get<std::int64_t>() : 0;
  }
  double number(const char* name) {
    const Json& found = member(name);
    sound_ = sound_ && found.is_number() && std::isfinite(found.get<double>());
    return sound_ ? found.get<double>() : 0.0;
  }
  Distribution::Sum large(const char* name) {
    const auto found = integer_of(member(name));
    sound_ = sound_ && found;
    return sound_ ? *found : 0;
  }
  std::vector<std::int64_t> counts(const char* name) {
    const Json& found = member(name);
    sound_ = sound_ && found.is_array() && std::all_of(found.begin(), found.end(), [](const Json& element) {
               return element.is_number_integer() && element.get<std::int64_t>() >= 0 && element.get<double>() < 1e18;
             });
    return sound_ ? found.get<std::vector<std::int64_t>>() : std::vector<std::int64_t>();
  }
  const Json& member(const char* name) {
    static const Json nothing;
    const auto found = sound_ ? json_.find(name) : json_.end();
    sound_ = sound_ && found != json_.end();
    return sound_ ? *found : nothing;
  }
  [[nodiscard]] bool sound() const { return sound_; }

 private:
  const Json& json_;
  bool sound_;
};

std::optional<Distribution> distribution_of(const Json& json) {
  Members members(json);
  Distribution::Contents contents;
  contents.ruler = {members.number("centre"), members.number("scale")};
  contents.count = members.count("count");
  contents.below = members.count("below");
  contents.above = members.count("above");
  contents.sum = members.large("sum");
  contents.squares = members.large("squares");
  const auto first = static_cast<std::size_t>(members.count("first_cell"));
  const auto cells = members.counts("cells");
  if (!members.sound() || !(contents.ruler.scale > 0.0) || first > Distribution::cells ||
      cells.size() > Distribution::cells - first) {
    return std::nullopt;
  }
  contents.counts.assign(Distribution::cells, 0);
  std::copy(cells.begin(), cells.end(), contents.counts.begin() + static_cast<std::ptrdiff_t>(first));
  const double inside = std::accumulate(cells.begin(), cells.end(), 0.0);
  const double all = inside + static_cast<double>(contents.below) + static_cast<double>(contents.above);
  return all == static_cast<double>(contents.count) ? std::optional<Distribution>(std::move(contents)) : std::nullopt;
}

}  // namespace

std::string state_text(const MonteCarloCount& count, const Json& made_from) {
  Json json;
  json["schema"] = state_schema;
  json["made_from"] = made_from;
  json["first"] = count.first;
  json["end"] = count.end;
  json["not_converged"] = count.not_converged;
  json["not_converged_first"] = count.not_converged_first;
  json["distributions"] = Json::array();
  for (const Distribution& distribution : count.distributions) {
    json["distributions"].push_back(distribution_json(distribution.contents()));
  }
  return json.dump() + "\n";
}

Expected<MonteCarloCount> read_state(const std::string& path, const Json& made_from) {
  const auto file = read_text_file(path, largest::monte_carlo_state);
  if (!file) {
    return tl::unexpected(file.error());
  }
  const auto parsed = parse_json(file->text, fmt::format("state of a Monte Carlo (\"{}\")", state_schema), path);
  if (!parsed) {
    return tl::unexpected(parsed.error());
  }
  const Json& json = *parsed;
  if (!json.is_object() || !json.contains("schema") || json.at("schema") != state_schema) {
    return bad_input(fmt::format("this is no state of a Monte Carlo (\"{}\")", state_schema), path);
  }
  if (!json.contains("made_from") || json.at("made_from") != made_from) {
    return bad_input(
        "these trials were made from another recording, with other options or by another version of the program: they "
        "cannot be put together with the ones asked for",
        path);
  }
  Members members(json);
  MonteCarloCount count;
  count.first = members.count("first");
  count.end = members.count("end");
  count.not_converged = members.count("not_converged");
  count.not_converged_first = members.counts("not_converged_first");
  const Json& distributions = members.member("distributions");
  bool sound = members.sound() && distributions.is_array() && count.end >= count.first && count.end <= max_trials &&
               count.not_converged <= count.end - count.first;
  for (std::size_t i = 0; sound && i < distributions.size(); ++i) {
    auto distribution = distribution_of(distributions[i]);
    sound = distribution && distribution->count() == count.end - count.first - count.not_converged;
    if (sound) {
      count.distributions.push_back(std::move(*distribution));
    }
  }
  if (!sound) {
    return bad_input("the state of the Monte Carlo is damaged: its counts contradict each other", path);
  }
  return count;
}

}  // namespace artcal
