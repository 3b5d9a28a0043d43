#include "app/report/sections/monte_carlo_section.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/results/shown_unit.h"
#include "app/results/uncertainty/measurand_family.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

constexpr std::size_t max_named = 8;

std::size_t count_where(const Json& quantities, const char* key, bool value) {
  return static_cast<std::size_t>(std::count_if(quantities.begin(), quantities.end(),
                                                [&](const Json& one) { return one.at(key).get<bool>() == value; }));
}

std::string noise_in_words(const Json& noise) {
  const auto one = [&](const char* key, double unit, const char* format) {
    return noise.at(key).is_null() ? std::string()
                                   : fmt::format(fmt::runtime(format), noise.at(key).get<double>() / unit);
  };
  std::string text = one("reading_mm", units::micrometre, "{:.3g} µm a reading");
  text += one("encoder_rad", units::arcsecond, "{:.3g}″ a joint");
  text += text.empty() || noise.at("probing_mm").is_null() ? "" : ", ";
  text += one("probing_mm", units::micrometre, "{:.3g} µm a coordinate");
  return text.empty() ? "estimated from the residuals" : text;
}

void write_sampled_parameters(const Json& quantities, Sheet& sheet) {
  html::Table table("Parameters of the arm; u is the standard uncertainty (k = 1)",
                    {{"parameter", false, true},
                     {"unit", false},
                     {"identified"},
                     {"u, first order"},
                     {"u, Monte Carlo", true, false, false, false, true},
                     {"95 % from"},
                     {"to"},
                     {"", false}});
  for (const Json& quantity : quantities) {
    if (quantity.at("kind") != "parameter") {
      continue;
    }
    const ShownUnit unit = shown_unit(quantity.at("name").get<std::string>(), quantity.at("unit").get<std::string>());
    const auto digits = [&](const Json& value) {
      return fmt::format("{:.{}f}", value.get<double>() / unit.size, unit.decimals);
    };
    const Json& interval = quantity.at("interval_95");
    table.add({shown(text_in(quantity, "name")), unit.name, digits(quantity.at("estimate")),
               two_digits(number_in(quantity.at("u_first_order")) / unit.size),
               two_digits(quantity.at("u").get<double>() / unit.size),
               interval.is_null() ? "–" : digits(interval.at(0)), interval.is_null() ? "–" : digits(interval.at(1)),
               quantity.at("differs_from_first_order").get<bool>() ? "⚠ differs" : ""});
  }
  sheet.table(table);
}

/// Several quantities of one kind in one row.
struct ShownFamily {
  std::string name;
  std::size_t count = 0;
  double first_order = 0.0, monte_carlo = 0.0;  // sums of squares
  double widest = 0.0;
  bool is_linear = true, differs = false;
};

std::vector<ShownFamily> families_of(const Json& quantities) {
  std::vector<ShownFamily> families;
  for (const Json& quantity : quantities) {
    const std::string name = measurand_family(quantity.at("kind"), quantity.at("name"));
    if (name.empty()) {
      continue;
    }
    auto family = std::find_if(families.begin(), families.end(), [&](const ShownFamily& f) { return f.name == name; });
    if (family == families.end()) {
      family = families.insert(families.end(), ShownFamily{name});
    }
    ++family->count;
    family->is_linear = family->is_linear && !quantity.at("u_first_order").is_null();
    family->first_order += family->is_linear ? std::pow(quantity.at("u_first_order").get<double>(), 2) : 0.0;
    family->monte_carlo += std::pow(quantity.at("u").get<double>(), 2);
    family->differs = family->differs || quantity.at("differs_from_first_order").get<bool>();
    if (const Json& interval = quantity.at("interval_95"); !interval.is_null()) {
      family->widest = std::max(family->widest, interval.at(1).get<double>() - interval.at(0).get<double>());
    }
  }
  return families;
}

void write_measurands(const Json& quantities, Sheet& sheet) {
  html::Table table("What the identified arm measures, µm; u is the root mean square over the places (k = 1)",
                    {{"measurand", false, true},
                     {"places"},
                     {"u, first order"},
                     {"u, Monte Carlo", true, false, false, false, true},
                     {"widest 95 % interval"},
                     {"", false}});
  for (const ShownFamily& family : families_of(quantities)) {
    const auto rms = [&](double squares) {
      return fmt::format("{:.2f}", std::sqrt(squares / static_cast<double>(family.count)) / units::micrometre);
    };
    table.add({shown(family.name), fmt::format("{}", family.count),
               family.is_linear ? rms(family.first_order) : "not linear", rms(family.monte_carlo),
               fmt::format("{:.2f}", family.widest / units::micrometre), family.differs ? "⚠ differs" : ""});
  }
  sheet.table(table);
}

void write_differences(const Json& quantities, Sheet& sheet) {
  std::vector<std::string> named;
  for (const Json& quantity : quantities) {
    if (quantity.at("differs_from_first_order").get<bool>()) {
      named.push_back(
          shown(fmt::format("{} {}: {:.2f} times the first order", text_in(quantity, "kind"), text_in(quantity, "name"),
                            quantity.at("u").get<double>() / number_in(quantity.at("u_first_order")))));
    }
  }
  if (named.empty()) {
    return;
  }
  sheet.note("⚠ Where u differs from the first order by more than 10 %, the Monte Carlo result holds:");
  const std::size_t more = named.size() - std::min(named.size(), max_named);
  named.resize(named.size() - more);
  if (more > 0) {
    named.push_back(fmt::format("{} more", more));
  }
  sheet.list(named);
}

}  // namespace

void write_monte_carlo_verdict(const Json& result, Sheet& sheet) {
  const Json& trials = result.at("trials");
  const Json& quantities = result.at("quantities");
  const std::size_t open = count_where(quantities, "stable", false);
  const std::size_t differing = count_where(quantities, "differs_from_first_order", true);
  const bool complete = trials.at("complete").get<bool>();
  const bool good = complete && open == 0;
  const int digits = result.at("options").at("digits").get<int>();
  sheet.verdict(
      good ? Mood::Good : Mood::Unsure,
      !complete ? "⚠ Stopped before there were enough trials"
      : good    ? fmt::format("✓ Uncertainties are stable to {}", plural(static_cast<std::size_t>(digits), "digit"))
                : "⚠ More trials are needed",
      fmt::format(
          "Identified {} times from readings and certificates drawn anew. {} {}.{}", trials.at("made").get<long>(),
          open == 0 ? std::string("All quantities are stable; of them")
                    : fmt::format("{} of {} quantities are not yet stable to {};", open, quantities.size(),
                                  plural(static_cast<std::size_t>(digits), "digit")),
          differing == 0 ? "none differs from its first-order uncertainty by more than 10 %"
                         : fmt::format("{} differ from their first-order uncertainty by more than 10 %", differing),
          result.at("warnings").empty() ? "" : " See the warnings below."));
}

void write_monte_carlo(const Json& result, Sheet& sheet) {
  const Json& trials = result.at("trials");
  const Json& options = result.at("options");
  sheet.facts({{"Arm", shown(text_in(result, "arm"))},
               {"Recording", shown(text_in(result, "recording"))},
               {"Model", shown(text_in(result, "model"))},
               {"Probe", shown(text_in(options, "probe"))},
               {"Noise of a reading", noise_in_words(options.at("noise"))},
               {"Trials", fmt::format("{}, of which {} did not converge", trials.at("made").get<long>(),
                                      trials.at("not_converged").get<long>())},
               {"Seed", fmt::format("{}", result.at("seed").get<std::uint64_t>())}});
  for (const Json& warning : result.at("warnings")) {
    sheet.note("⚠ " + as_sentence(warning.get<std::string>()));
  }
  const Json& quantities = result.at("quantities");
  write_sampled_parameters(quantities, sheet);
  write_measurands(quantities, sheet);
  write_differences(quantities, sheet);
  sheet.paragraph(
      "Monte Carlo as in JCGM 101: every trial draws the readings and the certified values from their distributions "
      "and identifies the arm again. Intervals are probabilistically symmetric.");
}

}  // namespace artcal
