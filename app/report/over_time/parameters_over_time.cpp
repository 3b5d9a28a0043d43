#include "app/report/over_time/parameters_over_time.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/report/over_time/calibrated_parameters.h"
#include "app/report/over_time/change_table.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using numbers::drawn;

/// Each result compared with the first, the first with itself.
struct ComparedResults {
  std::vector<ParameterComparison> with_first;
  std::string not_comparable;   ///< why one of them is not; or empty
  std::set<std::string> moved;  ///< fixed parameters whose values differed
};

const RecordedIdentification& identification_in(const RecordedResult& result) {
  return std::get<RecordedIdentification>(result.content);
}

ComparedResults compared(const DatedResults& results) {
  ComparedResults all;
  const CalibratedParameters first = calibrated_parameters(identification_in(*results.front()));
  for (const RecordedResult* result : results) {
    all.with_first.push_back(compare(first, calibrated_parameters(identification_in(*result))));
    const ParameterComparison& comparison = all.with_first.back();
    if (!comparison.not_comparable.empty()) {
      all.not_comparable = comparison.not_comparable;
      return all;
    }
    all.moved.insert(comparison.moved.begin(), comparison.moved.end());
  }
  return all;
}

// About how far the tip moves by one unit of a parameter, mm: by a compliance at 1 N·m, by an expansion at 10 K.
double tip_motion(const std::string& unit, double reach) {
  return unit == "mm" ? 1.0 : unit == "rad/(N mm)" ? 1e3 * reach : unit == "1/K" ? 10.0 * reach : reach;
}

// Places of the parameters that changed most against u from the first to the last.
std::vector<std::size_t> most_changed(const std::vector<ParameterChange>& changes) {
  const auto severity = [&](std::size_t k) { return std::abs(changes[k].now - changes[k].then) / changes[k].u; };
  std::vector<std::size_t> places(changes.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    places[k] = k;
  }
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return severity(a) > severity(b); });
  places.resize(std::min(places.size(), max_series));
  return places;
}

Figure drift_figure(const std::vector<ParameterComparison>& with_first, const ResultTimes& times, double reach) {
  const auto places = most_changed(with_first.back().changes);
  Json series = Json::array();
  for (const std::size_t k : places) {
    const ParameterChange& last = with_first.back().changes[k];
    const double scale = tip_motion(last.unit, reach) / units::micrometre;
    Json y = Json::array(), bars = Json::array();
    for (const ParameterComparison& comparison : with_first) {
      const ParameterChange& change = comparison.changes[k];
      y.push_back(drawn(scale * (change.now - change.then)));
      bars.push_back(&comparison == &with_first.front() ? Json(0.0) : drawn(scale * change.expanded));
    }
    series.push_back({{"name", last.name}, {"x", times.labels}, {"y", y}, {"bars", bars}});
  }
  return {
      "Drift of the parameters since the first identification",
      fmt::format(
          "The {} that changed most against their uncertainty. Angles by what they move the tip at full reach "
          "({:.0f} mm); bars are the expanded uncertainty of the change (k = 2, Student's factor below 60 degrees of "
          "freedom).",
          plural(places.size(), "parameter"), reach),
      {{"kind", "drift"}, {"quantity", "change"}, {"unit", "µm"}, {"dated", times.dated}, {"series", series}}};
}

// The first input is the recording.
bool share_a_recording(const DatedResults& results) {
  std::set<std::string> recordings;
  for (const RecordedResult* result : results) {
    if (!result->head.inputs.empty() && !recordings.insert(result->head.inputs.front().sha256).second) {
      return true;
    }
  }
  return false;
}

}  // namespace

void write_parameters_over_time(const DatedResults& identifications, Sheet& sheet) {
  sheet.part("Parameters");
  if (share_a_recording(identifications)) {
    sheet.note(
        "⚠ Some of these results are of the same recording. They are not independent: u of a change is too large.");
  }
  const ComparedResults all = compared(identifications);
  if (!all.not_comparable.empty()) {
    sheet.note(
        fmt::format("Their parameters cannot be compared one by one: {}. Identify all from the same nominal arm with "
                    "the same --hold and --free.",
                    all.not_comparable));
    return;
  }
  if (!all.moved.empty()) {
    sheet.note(
        fmt::format("{} was fixed at different values, and no reading sees the difference: the parameters of all "
                    "results are stated as they are where it has the value of the first.",
                    fmt::join(all.moved, ", ")));
  }
  const ResultTimes times = times_of(identifications);
  const auto& changes = all.with_first.back().changes;
  const double reach = identification_in(*identifications.front()).identifiability.angle_scale;
  sheet.figure(drift_figure(all.with_first, times, reach));
  sheet.table(change_table(fmt::format("From {} to {}; u is the standard uncertainty of the change",
                                       times.labels.front().get<std::string>(), times.labels.back().get<std::string>()),
                           changes));
  double widest = 0.0;
  for (const ParameterChange& change : changes) {
    widest = std::max(widest, change.limit);
  }
  sheet.paragraph(fmt::format(
      "Significant: a change beyond {:.1f} u, which by chance one of {} parameters shows in one of twenty comparisons. "
      "The results are taken to be independent of one another; what a common artefact is wrong by changes none of "
      "them.",
      widest, changes.size()));
}

}  // namespace artcal
