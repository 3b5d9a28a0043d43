#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/history/drift_sections.h"
#include "app/history/time_labels.h"
#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/report/over_time/change_table.h"
#include "app/results/shown_unit.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

constexpr double max_u = 2.0;  // of what is drawn of the first of them

/// The identifications that are comparable with the last, the oldest first.
std::vector<const Calibration*> comparable(const ArmHistory& history) {
  std::vector<const Calibration*> found;
  for (const Calibration& calibration : history.calibrations) {
    if (&calibration == &history.calibrations.back() ||
        step_between(calibration, history.calibrations.back()).not_comparable.empty()) {
      found.push_back(&calibration);
    }
  }
  return found;
}

TimeLabels labels_of(const std::vector<const Calibration*>& calibrations) {
  std::vector<const HistoryEntry*> entries;
  for (const Calibration* calibration : calibrations) {
    entries.push_back(&calibration->entry);
  }
  return time_labels(entries);
}

double extent(const ParameterChange& change) { return std::abs(change.now - change.then) + 2.0 * change.u; }
double severity_of_change(const ParameterChange& change) { return std::abs(change.now - change.then) / change.u; }

// Changes since the first, of the parameters that changed most against u.
Figure parameter_figure(const std::vector<const Calibration*>& calibrations, std::vector<ParameterChange> changes,
                        const std::string& unit, double size) {
  std::stable_sort(changes.begin(), changes.end(),
                   [](const auto& a, const auto& b) { return severity_of_change(a) > severity_of_change(b); });
  // A parameter that is told much more poorly would fill the picture with its bars.
  const double shown_size = extent(changes.front());
  std::erase_if(changes, [&](const ParameterChange& change) { return change.u > max_u * shown_size; });
  changes.resize(std::min(changes.size(), max_series));
  const TimeLabels times = labels_of(calibrations);
  std::vector<CalibrationStep> steps;  // all in the gauge of the first
  for (const Calibration* calibration : calibrations) {
    steps.push_back(step_between(*calibrations.front(), *calibration));
  }
  Json series = Json::array();
  for (const ParameterChange& change : changes) {
    Json y = Json::array(), bars = Json::array();
    for (const CalibrationStep& step : steps) {
      const auto at = std::find_if(step.changes.begin(), step.changes.end(),
                                   [&](const ParameterChange& other) { return other.name == change.name; });
      const bool is_known = at != step.changes.end();
      y.push_back(is_known ? drawn((at->now - at->then) / size) : Json(nullptr));
      bars.push_back(is_known && &step != &steps.front() ? drawn(at->expanded / size) : Json(0.0));
    }
    series.push_back({{"name", change.name}, {"x", times.labels}, {"y", y}, {"bars", bars}});
  }
  return {fmt::format("Drift of parameters in {}", unit),
          fmt::format("The {} that changed most against their uncertainty, since {}; bars are the expanded "
                      "uncertainty of the change (k = 2, Student's factor below 60 degrees of freedom). Parameters "
                      "told so poorly that no such change would show are left out.",
                      plural(changes.size(), "parameter"), times.labels.front()),
          {{"kind", "drift"}, {"quantity", "change"}, {"unit", unit}, {"dated", times.dated}, {"series", series}}};
}

// In a unit in which drifts have a few digits.
std::pair<std::string, double> drift_unit(const ParameterChange& change) {
  if (change.unit == "mm") {
    return {"µm", units::micrometre};
  }
  if (change.unit == "rad") {
    return {"arcsec", units::arcsecond};
  }
  const ShownUnit as = shown_unit(change.name, change.unit);
  return {as.name, as.size};
}

}  // namespace

void write_parameter_drift(const ArmHistory& history, Sheet& sheet) {
  if (history.calibrations.size() < 2) {
    return;
  }
  sheet.section("Parameters over time");
  const auto calibrations = comparable(history);
  if (calibrations.size() < history.calibrations.size()) {
    sheet.note(
        fmt::format("⚠ {} of {} identifications are not comparable with the last: other parameters were fixed in them, "
                    "or at other values, and others made up for it. They are left out here.",
                    history.calibrations.size() - calibrations.size(), history.calibrations.size()));
  }
  if (calibrations.size() < 2) {
    return;
  }
  const CalibrationStep overall = step_between(*calibrations.front(), *calibrations.back());
  if (!overall.moved.empty()) {
    sheet.note(
        fmt::format("{} was fixed at another value in the last, and no reading sees the difference: all "
                    "parameters are stated as they are where it has the value of the first.",
                    fmt::join(overall.moved, ", ")));
  }
  std::map<std::string, std::vector<ParameterChange>> by_unit;
  for (const ParameterChange& change : overall.changes) {
    by_unit[drift_unit(change).first].push_back(change);
  }
  for (const auto& [unit, changes] : by_unit) {
    sheet.figure(parameter_figure(calibrations, changes, unit, drift_unit(changes.front()).second));
  }
  const TimeLabels times = labels_of(calibrations);
  sheet.table(change_table(fmt::format("From {} to {}; u is the standard uncertainty of the change",
                                       times.labels.front(), times.labels.back()),
                           overall.changes));
  sheet.paragraph(fmt::format("All changes together: χ² = {:.4g}; chance stays below {:.4g} in 95 of 100 cases.{}",
                              overall.chi_squared, overall.limit,
                              overall.in_common.empty()
                                  ? ""
                                  : " The uncertainty of artefacts in common mostly cancels in a change; here it is "
                                    "counted twice: what is called significant is."));
}

}  // namespace artcal
