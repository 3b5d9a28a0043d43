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

using namespace numbers;
using Quantities = std::vector<RecordedQuantity>;

constexpr std::size_t max_named = 8;

std::string noise_in_words(const Noise& noise) {
  std::string text;
  text += noise.reading ? fmt::format("{:.3g} µm a reading", *noise.reading / units::micrometre) : "";
  text += noise.encoder ? fmt::format("{:.3g}″ a joint", *noise.encoder / units::arcsecond) : "";
  text += text.empty() || !noise.probing ? "" : ", ";
  text += noise.probing ? fmt::format("{:.3g} µm a coordinate", *noise.probing / units::micrometre) : "";
  return text.empty() ? "estimated from the residuals" : text;
}

void write_sampled_parameters(const Quantities& quantities, Sheet& sheet) {
  html::Table table("Parameters of the arm; u is the standard uncertainty (k = 1)",
                    {{"parameter", false, true},
                     {"unit", false},
                     {"identified"},
                     {"u, first order"},
                     {"u, Monte Carlo", true, false, false, false, true},
                     {"95 % from"},
                     {"to"},
                     {"", false}});
  for (const RecordedQuantity& quantity : quantities) {
    if (!quantity.is_parameter()) {
      continue;
    }
    const ShownUnit unit = shown_unit(quantity.name, quantity.unit);
    const auto digits = [&](double value) { return fmt::format("{:.{}f}", value / unit.size, unit.decimals); };
    const auto& interval = quantity.interval_95;
    table.add({shown(quantity.name), unit.name, digits(quantity.estimate),
               two_digits(quantity.u_first_order.value_or(NAN) / unit.size), two_digits(quantity.u / unit.size),
               interval ? digits(interval->low) : "–", interval ? digits(interval->high) : "–",
               quantity.differs_from_first_order ? "⚠ differs" : ""});
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

std::vector<ShownFamily> families_of(const Quantities& quantities) {
  std::vector<ShownFamily> families;
  for (const RecordedQuantity& quantity : quantities) {
    const std::string name = measurand_family(quantity.kind, quantity.name);
    if (name.empty()) {
      continue;
    }
    auto family = std::find_if(families.begin(), families.end(), [&](const ShownFamily& f) { return f.name == name; });
    if (family == families.end()) {
      family = families.insert(families.end(), ShownFamily{name});
    }
    ++family->count;
    family->is_linear = family->is_linear && quantity.u_first_order.has_value();
    family->first_order += family->is_linear ? std::pow(*quantity.u_first_order, 2) : 0.0;
    family->monte_carlo += std::pow(quantity.u, 2);
    family->differs = family->differs || quantity.differs_from_first_order;
    if (const auto& interval = quantity.interval_95) {
      family->widest = std::max(family->widest, interval->high - interval->low);
    }
  }
  return families;
}

void write_measurands(const Quantities& quantities, Sheet& sheet) {
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

void write_differences(const Quantities& quantities, Sheet& sheet) {
  std::vector<std::string> named;
  for (const RecordedQuantity& quantity : quantities) {
    if (quantity.differs_from_first_order) {
      named.push_back(shown(fmt::format("{} {}: {:.2f} times the first order", quantity.kind, quantity.name,
                                        quantity.u / quantity.u_first_order.value_or(NAN))));
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

void write_monte_carlo_verdict(const RecordedMonteCarlo& result, Sheet& sheet) {
  const Quantities& quantities = result.quantities;
  const auto open = static_cast<std::size_t>(
      std::count_if(quantities.begin(), quantities.end(), [](const auto& quantity) { return !quantity.is_stable; }));
  const auto differing = static_cast<std::size_t>(std::count_if(
      quantities.begin(), quantities.end(), [](const auto& quantity) { return quantity.differs_from_first_order; }));
  const bool good = result.is_complete && open == 0;
  const std::string digits = plural(static_cast<std::size_t>(result.digits), "digit");
  sheet.verdict(
      good ? Mood::Good : Mood::Unsure,
      !result.is_complete ? "⚠ Stopped before there were enough trials"
      : good              ? fmt::format("✓ Uncertainties are stable to {}", digits)
                          : "⚠ More trials are needed",
      fmt::format(
          "Identified {} times from readings and certificates drawn anew. {} {}.{}", result.trials,
          open == 0 ? std::string("All quantities are stable; of them")
                    : fmt::format("{} of {} quantities are not yet stable to {};", open, quantities.size(), digits),
          differing == 0 ? "none differs from its first-order uncertainty by more than 10 %"
                         : fmt::format("{} differ from their first-order uncertainty by more than 10 %", differing),
          result.warnings.empty() ? "" : " See the warnings below."));
}

void write_monte_carlo(const RecordedHead& head, const RecordedMonteCarlo& result, Sheet& sheet) {
  sheet.facts({{"Arm", shown(head.arm)},
               {"Recording", shown(head.recording)},
               {"Model", shown(result.model)},
               {"Probe", shown(result.probe)},
               {"Noise of a reading", noise_in_words(result.noise)},
               {"Trials", fmt::format("{}, of which {} did not converge", result.trials, result.not_converged)},
               {"Seed", fmt::format("{}", result.seed)}});
  for (const std::string& warning : result.warnings) {
    sheet.note("⚠ " + as_sentence(warning));
  }
  write_sampled_parameters(result.quantities, sheet);
  write_measurands(result.quantities, sheet);
  write_differences(result.quantities, sheet);
  sheet.paragraph(
      "Monte Carlo as in JCGM 101: every trial draws the readings and the certified values from their distributions "
      "and identifies the arm again. Intervals are probabilistically symmetric.");
}

}  // namespace artcal
