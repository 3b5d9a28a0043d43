#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "app/history/drift_sections.h"
#include "app/history/over_time.h"
#include "app/history/time_labels.h"
#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/report/over_time/change_table.h"
#include "app/report/sections/test_values.h"
#include "app/results/verification/standard_name.h"
#include "core/statistics.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

constexpr std::size_t max_values_listed = 60;

/// The verifications by one standard, and what their times are called.
struct Times {
  std::vector<std::size_t> verifications;  ///< into ArmHistory::verifications
  TimeLabels names;

  [[nodiscard]] const std::string& name(std::size_t verification) const {
    const auto at = std::find(verifications.begin(), verifications.end(), verification);
    return names.labels.at(static_cast<std::size_t>(at - verifications.begin()));
  }
};

Times times_of(const ArmHistory& history, const std::string& standard) {
  Times times;
  std::vector<const HistoryEntry*> entries;
  for (std::size_t i = 0; i < history.verifications.size(); ++i) {
    if (history.verifications[i].standard == standard) {
      times.verifications.push_back(i);
      entries.push_back(&history.verifications[i].entry);
    }
  }
  times.names = time_labels(entries);
  return times;
}

std::string place_of(const std::string& placement, const std::string& first, const std::string& second) {
  return (placement.empty() ? "" : shown(placement) + ": ") + shown(first) +
         (second.empty() ? "" : " – " + shown(second));
}

/// A line of a picture; values in mm.
struct Line {
  Json x = Json::array(), y = Json::array(), bars = Json::array();

  void add(const std::string& when, double value, double expanded) {
    x.push_back(when);
    y.push_back(drawn(value / units::micrometre));
    bars.push_back(drawn(expanded / units::micrometre));
  }
  [[nodiscard]] Json series(const std::string& name) const {
    return {{"name", name}, {"x", x}, {"y", y}, {"bars", bars}};
  }
};

Json figure_data(const char* quantity, const Times& times, const Json& series) {
  return {{"kind", "drift"}, {"quantity", quantity}, {"unit", "µm"}, {"dated", times.names.dated}, {"series", series}};
}

void write_worst(const std::vector<WorstOverTime>& all, const Times& times, Sheet& sheet) {
  Json series = Json::array();
  html::Table table(
      fmt::format("The worst of each quantity over time, µm: {}; u is the standard uncertainty of the test "
                  "value",
                  worst_is),
      {{"quantity", false, true},
       {"date", false, false, true},
       {"value", true, false, false, false, true},
       {"u"},
       {"limit"},
       {"verdict", false, false, false, false, true},
       {"where", false}});
  for (const WorstOverTime& worst : all) {
    Line line;
    for (const auto& [verification, value] : worst.points) {
      const double u = value->budget.total();
      line.add(times.name(verification), std::abs(value->value),
               stated_coverage_factor(value->budget.degrees_of_freedom()) * u);
      table.add({name_of(worst.quantity), times.name(verification),
                 deviation_micrometres(value->value, is_signed(worst.quantity)), two_digits(u / units::micrometre),
                 value->limit ? micrometres(*value->limit) : "–", text_of(value->verdict),
                 place_of(value->placement, value->first, value->second)});
    }
    series.push_back(line.series(name_of(worst.quantity)));
  }
  sheet.figure(
      {"The worst of each quantity over time",
       fmt::format("Of each verification {}. Sizes without sign; bars are the expanded uncertainty of the test value "
                   "(k = 2, Student's factor below 60 degrees of freedom).",
                   worst_is),
       figure_data("worst", times, series)});
  sheet.table(table);
}

double severity_of_drift(const Drift& drift) { return std::abs(drift.drift) / drift.u; }

bool is_of(const ValueOverTime& value, const Drift& drift) {
  return value.quantity == drift.quantity && value.artefact == drift.artefact && value.placement == drift.placement &&
         value.first == drift.first && value.second == drift.second;
}

// Of one quantity, sorted by how much they changed.
void write_most_changed(const std::vector<Drift>& drifts, const std::vector<ValueOverTime>& values, const Times& times,
                        Sheet& sheet) {
  const char* quantity = name_of(drifts.front().quantity);
  Json series = Json::array();
  for (std::size_t i = 0; i < std::min(max_series, drifts.size()); ++i) {
    const auto value =
        std::find_if(values.begin(), values.end(), [&](const ValueOverTime& one) { return is_of(one, drifts[i]); });
    Line line;
    for (const ValueThen& point : value->points) {
      line.add(times.name(point.verification), point.value, point.coverage_factor * point.u);
    }
    series.push_back(line.series(place_of(value->placement, value->first, value->second)));
  }
  sheet.figure(
      {fmt::format("{} over time", quantity),
       fmt::format("The {} of {} that changed most against the uncertainty of the change. Means of repeats; bars "
                   "are their expanded uncertainty (k = 2, Student's factor below 60 degrees of freedom).",
                   plural(series.size(), "value"), drifts.size()),
       figure_data(quantity, times, series)});
}

std::vector<Drift> sorted(std::vector<Drift> drifts) {
  std::stable_sort(drifts.begin(), drifts.end(),
                   [](const Drift& a, const Drift& b) { return severity_of_drift(a) > severity_of_drift(b); });
  return drifts;
}

void write_changes(const std::vector<Drift>& drifts, const Times& times, Sheet& sheet) {
  std::vector<ShownChange> shown_changes;
  for (std::size_t i = 0; i < std::min(max_values_listed, drifts.size()); ++i) {
    const Drift& drift = drifts[i];
    shown_changes.push_back({html::cell(name_of(drift.quantity)),
                             html::cell(place_of(drift.placement, drift.first, drift.second)),
                             deviation_micrometres(drift.then, is_signed(drift.quantity)),
                             deviation_micrometres(drift.now, is_signed(drift.quantity)),
                             signed_micrometres(drift.drift), drift.u / units::micrometre, severity_of_drift(drift),
                             drift.significant, drift.degrees_of_freedom > 0 ? "" : "not repeated"});
  }
  sheet.table(change_table(fmt::format("Changes from {} to {}, µm, those that are largest against u first",
                                       times.names.labels.front(), times.names.labels.back()),
                           "quantity", "where", shown_changes));
  if (drifts.size() > max_values_listed) {
    sheet.paragraph(
        fmt::format("{} more changed less; artcal history --json has them.", drifts.size() - max_values_listed));
  }
}

}  // namespace

void write_value_drift(const ArmHistory& history, Sheet& sheet) {
  std::map<std::string, std::vector<WorstOverTime>> worst;
  for (WorstOverTime& one : worst_over_time(history)) {
    worst[one.standard].push_back(std::move(one));
  }
  std::map<std::string, std::vector<ValueOverTime>> values;
  for (ValueOverTime& one : values_over_time(history)) {
    values[one.standard].push_back(std::move(one));
  }
  for (const auto& [standard, of_standard] : worst) {
    const Times times = times_of(history, standard);
    if (times.verifications.size() < 2) {
      continue;
    }
    sheet.section(fmt::format("Values by {} over time", standard_in_words(standard)));
    write_worst(of_standard, times, sheet);
    const InterimCheck check = compare(history.verifications[times.verifications.back()].values,
                                       history.verifications[times.verifications.front()].values);
    const auto drifts = sorted(check.drifts);
    std::map<Quantity, std::vector<Drift>> by_quantity;
    for (const Drift& drift : drifts) {
      by_quantity[drift.quantity].push_back(drift);
    }
    for (const auto& [quantity, of_quantity] : by_quantity) {
      write_most_changed(of_quantity, values[standard], times, sheet);
    }
    write_changes(drifts, times, sheet);
    if (!check.any_judged()) {
      sheet.note("⚠ Without repeats nothing can be called significant.");
    }
  }
}

}  // namespace artcal
