#include "app/report/sections/drift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/report/sections/change_table.h"
#include "app/report/sections/test_values.h"
#include "app/results/verification/gauge.h"
#include "app/results/verification/standard_name.h"
#include "core/statistics.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using Results = std::vector<const Json*>;
using namespace numbers;

constexpr std::size_t max_drawn = 6;

/// Of several results, in order of their dates.
struct Times {
  Json labels = Json::array();
  bool dated = true;
};

Results of_kind(const std::vector<ReportedResult>& results, ResultKind kind) {
  Results found;
  for (const ReportedResult& result : results) {
    if (result.kind == kind) {
      found.push_back(&result.json);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Json* a, const Json* b) { return text_in(*a, "date") < text_in(*b, "date"); });
  return found;
}

// Dates where all are stated and differ; else the results' numbers.
Times times_of(const Results& results) {
  Times times;
  std::string last;
  for (const Json* result : results) {
    const std::string date = text_in(*result, "date");
    times.dated = times.dated && !date.empty() && date != last;
    last = date;
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    times.labels.push_back(times.dated ? text_in(*results[i], "date") : fmt::format("result {}", i + 1));
  }
  return times;
}

const Json& parameter_named(const Json& result, const std::string& name) {
  const Json& parameters = result.at("parameters");
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Json& parameter) { return parameter.at("name") == name; });
  if (found == parameters.end()) {
    throw std::out_of_range("a parameter of the covariance is not among the parameters");
  }
  return *found;
}

/// One parameter over time.
struct Track {
  std::string name;
  std::string unit;
  std::vector<double> values, u;  ///< mm or rad
  std::vector<double> freedom;    ///< degrees of freedom of each u

  [[nodiscard]] double change(std::size_t i) const { return values[i] - values.front(); }
  // The results are independent of one another.
  [[nodiscard]] double u_of_change(std::size_t i) const { return std::hypot(u[i], u.front()); }
  [[nodiscard]] double freedom_of_change(std::size_t i) const {
    return effective_degrees_of_freedom(
        std::array<UncertaintyComponent, 2>{{{u[i], freedom[i]}, {u.front(), freedom.front()}}});
  }
  [[nodiscard]] double standardised() const { return std::abs(change(u.size() - 1)) / u_of_change(u.size() - 1); }
};

GaugedParameters gauged(const Json& result) {
  GaugedParameters gauged;
  const Json& parameters = result.at("parameters");
  const auto size = static_cast<Eigen::Index>(parameters.size());
  gauged.values.resize(size);
  std::map<std::string, Eigen::Index> places;
  for (Eigen::Index i = 0; i < size; ++i) {
    const Json& parameter = parameters[static_cast<std::size_t>(i)];
    gauged.names.push_back(parameter.at("name"));
    gauged.is_angle.push_back(parameter.at("unit") == "rad");
    gauged.values[i] = parameter.at("identified");
    places[gauged.names.back()] = i;
  }
  for (const Json& name : result.at("covariance").at("parameters")) {
    gauged.estimated.push_back(places.at(name.get<std::string>()));
  }
  const Json& matrix = result.at("covariance").at("matrix");
  const auto estimated = static_cast<Eigen::Index>(gauged.estimated.size());
  gauged.covariance.resize(estimated, estimated);
  for (Eigen::Index i = 0; i < estimated; ++i) {
    for (Eigen::Index j = 0; j < estimated; ++j) {
      gauged.covariance(i, j) = matrix.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j));
    }
  }
  const Json& unidentifiable = result.at("coupling").at("unidentifiable");
  gauged.unidentifiable = Eigen::MatrixXd::Zero(size, static_cast<Eigen::Index>(unidentifiable.size()));
  for (std::size_t k = 0; k < unidentifiable.size(); ++k) {
    for (const auto& [name, coefficient] : unidentifiable[k].at("motion").items()) {
      gauged.unidentifiable(places.at(name), static_cast<Eigen::Index>(k)) = coefficient;
    }
  }
  return gauged;
}

double freedom_in(const Json& parameter) {
  const bool is_few = parameter.contains("degrees_of_freedom") && parameter["degrees_of_freedom"].is_number();
  return is_few ? parameter["degrees_of_freedom"].get<double>() : std::numeric_limits<double>::infinity();
}

// Of u of a parameter; where it is fixed, of the poorest known one, of which it takes over a part.
double freedom_in(const Json& result, const std::string& name) {
  const Json& parameter = parameter_named(result, name);
  double smallest = freedom_in(parameter);
  if (parameter.at("standard_uncertainty").is_null()) {
    for (const Json& other : result.at("parameters")) {
      smallest = std::min(smallest, freedom_in(other));
    }
  }
  return smallest;
}

/// The parameters that the first of several results identified, in its gauge over all of them.
struct Tracks {
  std::vector<Track> all;
  std::string not_comparable;   ///< why there are none; or empty
  std::set<std::string> moved;  ///< fixed parameters whose values differed
};

Tracks tracks_of(const Results& results) {
  Tracks tracks;
  const GaugedParameters first = gauged(*results.front());
  for (const Eigen::Index i : first.estimated) {
    const std::string& name = first.names[static_cast<std::size_t>(i)];
    tracks.all.push_back({name, parameter_named(*results.front(), name).at("unit"), {}, {}, {}});
  }
  for (const Json* result : results) {
    const InGauge stated = in_gauge_of(first, gauged(*result));
    if (!stated.not_comparable.empty()) {
      tracks.not_comparable = stated.not_comparable;
      return tracks;
    }
    tracks.moved.insert(stated.moved.begin(), stated.moved.end());
    for (std::size_t k = 0; k < tracks.all.size(); ++k) {
      Track& track = tracks.all[k];
      track.values.push_back(stated.values[first.estimated[k]]);
      track.u.push_back(std::sqrt(stated.covariance.diagonal()[static_cast<Eigen::Index>(k)]));
      track.freedom.push_back(freedom_in(*result, track.name));
    }
  }
  return tracks;
}

// About how far the tip moves by one unit of a parameter, mm: by a compliance at 1 N·m, by an expansion at 10 K.
double tip_motion(const std::string& unit, double reach) {
  return unit == "mm" ? 1.0 : unit == "rad/(N mm)" ? 1e3 * reach : unit == "1/K" ? 10.0 * reach : reach;
}

Figure drift_figure(std::vector<Track> tracks, const Times& times, double reach) {
  std::stable_sort(tracks.begin(), tracks.end(),
                   [](const Track& a, const Track& b) { return a.standardised() > b.standardised(); });
  tracks.resize(std::min(tracks.size(), max_drawn));
  Json series = Json::array();
  for (const Track& track : tracks) {
    const double scale = tip_motion(track.unit, reach) / units::micrometre;
    Json y = Json::array(), bars = Json::array();
    for (std::size_t i = 0; i < track.values.size(); ++i) {
      y.push_back(drawn(scale * track.change(i)));
      bars.push_back(i == 0 ? Json(0.0)
                            : drawn(stated_coverage_factor(track.freedom_of_change(i)) * scale * track.u_of_change(i)));
    }
    series.push_back({{"name", track.name}, {"x", times.labels}, {"y", y}, {"bars", bars}});
  }
  return {
      "Drift of the parameters since the first identification",
      fmt::format(
          "The {} that changed most against their uncertainty. Angles by what they move the tip at full reach "
          "({:.0f} mm); bars are the expanded uncertainty of the change (k = 2, Student's factor below 60 degrees of "
          "freedom).",
          plural(tracks.size(), "parameter"), reach),
      {{"kind", "drift"}, {"quantity", "change"}, {"unit", "µm"}, {"dated", times.dated}, {"series", series}}};
}

bool share_a_recording(const Results& results) {
  std::set<Json> recordings;
  for (const Json* result : results) {
    recordings.insert(result->at("inputs").at(0).at("sha256"));
  }
  return recordings.size() < results.size();
}

void write_parameters(const Results& results, Sheet& sheet) {
  sheet.part("Parameters");
  if (share_a_recording(results)) {
    sheet.note(
        "⚠ Some of these results are of the same recording. They are not independent: u of a change is too large.");
  }
  const Tracks found = tracks_of(results);
  if (!found.not_comparable.empty()) {
    sheet.note(
        fmt::format("Their parameters cannot be compared one by one: {}. Identify all from the same nominal arm with "
                    "the same --hold and --free.",
                    found.not_comparable));
    return;
  }
  if (!found.moved.empty()) {
    sheet.note(
        fmt::format("{} was fixed at different values, and no reading sees the difference: the parameters of all "
                    "results are stated as they are where it has the value of the first.",
                    fmt::join(found.moved, ", ")));
  }
  const std::vector<Track>& tracks = found.all;
  const Times times = times_of(results);
  const std::size_t last = results.size() - 1;
  double widest = 0.0;
  const auto limit_of = [&](const Track& track) {
    return significance_factor(tracks.size(), track.freedom_of_change(last));
  };
  sheet.figure(drift_figure(tracks, times, results.front()->at("coupling").at("angle_scale_mm")));
  html::Table table =
      change_table(fmt::format("From {} to {}; u is the standard uncertainty of the change",
                               times.labels.front().get<std::string>(), times.labels.back().get<std::string>()));
  for (const Track& track : tracks) {
    add(table, {track.name, track.unit, track.values.front(), track.values.back(), track.u_of_change(last),
                track.standardised() > limit_of(track) ? "⚠ significant" : ""});
  }
  for (const Track& track : tracks) {
    widest = std::max(widest, limit_of(track));
  }
  sheet.table(table);
  sheet.paragraph(fmt::format(
      "Significant: a change beyond {:.1f} u, which by chance one of {} parameters shows in one of twenty comparisons. "
      "The results are taken to be independent of one another; what a common artefact is wrong by changes none of "
      "them.",
      widest, tracks.size()));
}

void write_test_values(const Results& results, const std::string& standard, Sheet& sheet) {
  const Times times = times_of(results);
  std::map<std::string, std::vector<const Json*>> worst;
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const ValuesOfQuantity& quantity : by_quantity(results[i]->at("values"))) {
      worst[quantity.quantity].resize(results.size());
      worst[quantity.quantity][i] = quantity.worst;
    }
  }
  sheet.part(fmt::format("Values by {}", standard_in_words(standard)));
  Json series = Json::array();
  html::Table table(fmt::format("The worst of each quantity over time, µm: {}", worst_is),
                    {{"quantity", false, true},
                     {"when", false},
                     {"value"},
                     {"limit"},
                     {"u"},
                     {"verdict", false, false, false, false, true}});
  for (const auto& [quantity, values] : worst) {
    Json x = Json::array(), y = Json::array(), bars = Json::array();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] == nullptr) {
        continue;
      }
      const Json& value = *values[i];
      const std::string when = times.labels[i];
      table.add({shown(quantity), when, value_in_words(value),
                 value.at("limit_mm").is_null() ? "–" : micrometres(value.at("limit_mm")),
                 micrometres(value.at("u_mm")), verdict_in_words(value)});
      x.push_back(when);
      y.push_back(drawn(std::abs(value.at("value_mm").get<double>()) / units::micrometre));
      bars.push_back(drawn(2.0 * value.at("u_mm").get<double>() / units::micrometre));
    }
    series.push_back({{"name", shown(quantity)}, {"x", x}, {"y", y}, {"bars", bars}});
  }
  sheet.figure(
      {"The worst of each quantity over time",
       fmt::format(
           "Of each verification {}. Sizes without sign; bars are twice the standard uncertainty of the test value.",
           worst_is),
       {{"kind", "drift"}, {"quantity", "worst"}, {"unit", "µm"}, {"dated", times.dated}, {"series", series}}});
  sheet.table(table);
}

}  // namespace

void write_drift(const std::vector<ReportedResult>& results, Sheet& sheet) {
  const Results identifications = of_kind(results, ResultKind::Identification);
  std::map<std::string, Results> by_standard;
  for (const Json* verification : of_kind(results, ResultKind::Verification)) {
    by_standard[text_in(*verification, "standard")].push_back(verification);
  }
  std::erase_if(by_standard, [](const auto& entry) { return entry.second.size() < 2; });
  if (identifications.size() < 2 && by_standard.empty()) {
    return;
  }
  sheet.section("Over time");
  if (identifications.size() > 1) {
    write_parameters(identifications, sheet);
  }
  for (const auto& [standard, verifications] : by_standard) {
    write_test_values(verifications, standard, sheet);
  }
}

}  // namespace artcal
