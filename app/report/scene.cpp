#include "app/report/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/report/thinning.h"
#include "app/results/result_names.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

constexpr int max_vectors = 1200;
constexpr std::size_t max_in_a_line = 8;  // features of a bar; those of a plate stay dots
// Of the scene's size: the rms of the errors, and the longest.
constexpr double rms_drawn = 0.03, longest_drawn = 0.25;

/// Points as a picture takes them: x, y, z; a gap ends a line.
class Points {
 public:
  void add(const Eigen::Vector3d& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns_[axis].push_back(drawn(point[static_cast<Eigen::Index>(axis)]));
    }
  }
  void gap() {
    for (Json& column : columns_) {
      column.push_back(nullptr);
    }
  }
  [[nodiscard]] Json json() const { return {{"x", columns_[0]}, {"y", columns_[1]}, {"z", columns_[2]}}; }

 private:
  std::array<Json, 3> columns_{Json::array(), Json::array(), Json::array()};
};

Json arm_in_scene(const std::vector<Eigen::Vector3d>& path) {
  Points points;
  for (const Eigen::Vector3d& point : path) {
    points.add(point);
  }
  return points.json();
}

Json artefacts_of(const std::vector<RecordedFeature>& features) {
  std::map<std::pair<std::string, std::string>, std::vector<Eigen::Vector3d>> placements;
  Points dots, lines;
  Json names = Json::array();
  for (const RecordedFeature& feature : features) {
    dots.add(feature.at);
    names.push_back(shown(fmt::format("{}: {}", feature.placement, feature.feature)));
    placements[{feature.artefact, feature.placement}].push_back(feature.at);
  }
  for (const auto& [name, points] : placements) {
    if (points.size() > 1 && points.size() <= max_in_a_line) {
      std::for_each(points.begin(), points.end(), [&](const Eigen::Vector3d& point) { lines.add(point); });
      lines.gap();
    }
  }
  return {{"dots", dots.json()}, {"names", names}, {"lines", lines.json()}};
}

double size_of(const std::vector<std::vector<double>>& tip) {
  double size = 0.0;
  for (const auto& column : tip) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : column) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
    size = std::max(size, high - low);
  }
  return size;
}

// 1, 2 or 5 times a power of ten.
double round_below(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  return power * (value >= 5.0 * power ? 5.0 : value >= 2.0 * power ? 2.0 : 1.0);
}

// Such that errors are seen beside a scene of metres.
double magnification_for(const std::vector<double>& lengths, double scene) {
  double squares = 0.0, longest = 0.0;
  for (const double length : lengths) {
    squares += length * length;
    longest = std::max(longest, length);
  }
  if (longest == 0.0) {
    return 1.0;
  }
  const double rms = std::sqrt(squares / static_cast<double>(lengths.size()));
  return std::max(1.0, round_below(std::min(rms_drawn * scene / rms, longest_drawn * scene / longest)));
}

}  // namespace

Figure scene_of(const RecordedIdentification& identification) {
  const RecordedReadings& readings = *identification.readings;
  std::vector<double> order, length;
  for (std::size_t i = 0; i < readings.feature.size(); ++i) {
    order.push_back(static_cast<double>(i));
    length.push_back(std::hypot(readings.offset[0][i], readings.offset[1][i], readings.offset[2][i]));
  }
  const double longest = length.empty() ? 0.0 : *std::max_element(length.begin(), length.end());
  const double magnification = magnification_for(length, std::max(size_of(readings.tip), 1.0));
  Points vectors;
  const auto kept = thinned(order, length, max_vectors);
  for (const int i : kept) {
    const Eigen::Vector3d offset(readings.offset[0][i], readings.offset[1][i], readings.offset[2][i]);
    const Eigen::Vector3d to = Eigen::Vector3d(readings.tip[0][i], readings.tip[1][i], readings.tip[2][i]) - offset;
    const Eigen::Vector3d from = to + magnification * offset;
    vectors.add(to);
    vectors.add(from);
    vectors.gap();
  }
  return {
      "The arm, the placements of the artefacts and the errors of the readings",
      fmt::format("{}, {}. Errors are lines from where the tip should have been towards where it was, {:g} times as "
                  "long as they are; the longest is {} mm. The arm stands in the posture of one reading. Drag to "
                  "turn.{}",
                  plural(identification.after.placements.size(), "placement"),
                  plural(readings.feature.size(), "reading"), magnification, mm(longest),
                  kept.size() == order.size() ? "" : fmt::format(" {} errors are drawn.", kept.size())),
      {{"kind", "scene"},
       {"arm", arm_in_scene(identification.arm_path)},
       {"artefacts", artefacts_of(identification.features)},
       {"vectors", vectors.json()},
       {"magnification", magnification}},
      true};
}

Figure scene_of_verification(const RecordedVerification& verification) {
  std::map<std::string, Points> by_verdict;
  std::map<std::string, Json> names;
  for (const RecordedValue& value : verification.values) {
    const std::string verdict = result_name(value.verdict);
    by_verdict[verdict].add(value.place.point_in_base);
    Json& of = names.try_emplace(verdict, Json::array()).first->second;
    of.push_back(shown(fmt::format("{} {}: {} {} µm", value.quantity, value.placement, value.first,
                                   deviation_micrometres(value.value, value.certified.has_value()))));
  }
  Json places = Json::array();
  for (const auto& [verdict, points] : by_verdict) {
    places.push_back({{"verdict", verdict}, {"points", points.json()}, {"names", names[verdict]}});
  }
  return {
      "Where the arm was tested",
      fmt::format(
          "Squares: the features of the artefacts where they were measured, joined by lines where an artefact has "
          "few. Marks lie on the feature that was judged, of a length in its middle. Dots: conformity proven; crosses: "
          "non-conformity proven; diamonds: neither proven; open circles: not judged.{} Drag to turn.",
          verification.arm_path.empty() ? "" : " The arm stands in the posture of one reading."),
      {{"kind", "places"},
       {"arm", arm_in_scene(verification.arm_path)},
       {"artefacts", artefacts_of(verification.features)},
       {"places", places}},
      true};
}

}  // namespace artcal
