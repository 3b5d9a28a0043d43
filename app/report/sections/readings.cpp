#include "app/report/sections/readings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "app/report/numbers.h"
#include "app/report/thinning.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

constexpr int max_drawn = 2400;
constexpr int max_drawn_a_joint = 480;

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) {
    largest = std::max(largest, std::isfinite(value) ? std::abs(value) : 0.0);
  }
  return largest;
}

// What a caption says where not every reading is drawn.
std::string thinned_in_words(std::size_t drawn_count, std::size_t count) {
  return drawn_count == count ? ""
                              : fmt::format(
                                    " Of {} readings {} are drawn, the extremes among them; all numbers are of "
                                    "all readings.",
                                    count, drawn_count);
}

/// A run of readings of one artefact in one placement.
struct Run {
  std::string name;
  std::size_t begin = 0, end = 0;
};

std::vector<Run> runs_of(const std::vector<RecordedFeature>& features, const std::vector<std::size_t>& feature,
                         bool several_artefacts) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < feature.size(); ++i) {
    const RecordedFeature& of = features[feature[i]];
    const std::string placement = of.placement.empty() ? "–" : of.placement;
    const std::string name = shown(several_artefacts ? of.artefact + ", " + placement : placement);
    if (runs.empty() || runs.back().name != name) {
      runs.push_back({name, i, i});
    }
    runs.back().end = i + 1;
  }
  return runs;
}

double rms_of(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) {
    squares += value * value;
  }
  return values.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace

Figure residuals_by_placement(const RecordedIdentification& identification) {
  const RecordedReadings& readings = *identification.readings;
  const auto runs = runs_of(identification.features, readings.feature, identification.after.artefacts > 1);
  std::vector<double> order(readings.after.size());
  std::iota(order.begin(), order.end(), 0.0);
  const auto kept = thinned(order, readings.after, max_drawn);
  const DrawnUnit unit = drawn_unit(largest_of(readings.after));
  Json x = Json::array(), y = Json::array(), groups = Json::array();
  for (const int i : kept) {
    x.push_back(i);
    y.push_back(drawn(unit.per_mm * readings.after[i]));
  }
  for (const Run& run : runs) {
    groups.push_back({{"name", run.name}, {"begin", run.begin}, {"end", run.end}});
  }
  const double rms = rms_of(readings.after);
  return {"Deviations of the readings by placement, identified arm",
          fmt::format("rms {} mm (dotted lines), largest {} mm. Each mark is one reading, in the order of placements; "
                      "neighbouring placements have different marks. Deviations of points have no sign.{}",
                      mm(rms), mm(largest_of(readings.after)), thinned_in_words(kept.size(), order.size())),
          {{"kind", "placements"},
           {"unit", unit.name},
           {"x", x},
           {"y", y},
           {"groups", groups},
           {"rms", drawn(unit.per_mm * rms)}}};
}

Figure residuals_by_joint(const RecordedReadings& readings) {
  const DrawnUnit unit = drawn_unit(largest_of(readings.after));
  Json panels = Json::array();
  std::size_t least_drawn = readings.after.size();
  for (std::size_t joint = 0; joint < readings.joints.size(); ++joint) {
    const auto& angles = readings.joints[joint];
    const bool slides = std::count(readings.prismatic.begin(), readings.prismatic.end(), joint + 1) > 0;
    const auto kept = thinned(angles, readings.after, max_drawn_a_joint);
    least_drawn = std::min(least_drawn, kept.size());
    Json x = Json::array(), y = Json::array();
    for (const int i : kept) {
      x.push_back(drawn(angles[i] / (slides ? 1.0 : units::degree)));
      y.push_back(drawn(unit.per_mm * readings.after[i]));
    }
    panels.push_back({{"x", x}, {"y", y}});
  }
  return {"Deviations of the readings by joint angle, identified arm",
          fmt::format("One panel a joint, its angle in degrees (of a prismatic joint its travel in mm) across. A wave "
                      "of one or two periods a turn points to an "
                      "eccentric encoder, a slope or a step to a joint that bends.{}",
                      thinned_in_words(least_drawn, readings.after.size())),
          {{"kind", "joints"}, {"unit", unit.name}, {"panels", panels}},
          true};
}

}  // namespace artcal
