#include "artefacts/simulation/stand.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Part of a segment within one pair of planes; from > to where there is none.
struct Part {
  double from = 0.0, to = 1.0;

  void keep_between(double begin, double step, double low, double high) {
    if (step == 0.0) {
      to = begin > low && begin < high ? to : -1.0;
      return;
    }
    const double a = (low - begin) / step, b = (high - begin) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
};

// With the larger of the two radii around it. By slabs (Kay, Kajiya 1986).
bool goes_into(const Obstacle& table, const StandingFeature& first, const StandingFeature& second) {
  const double margin = std::max(first.radius, second.radius);
  const Eigen::Vector3d step = second.at_in_base - first.at_in_base;
  Part part;
  part.keep_between(first.at_in_base.x(), step.x(), table.x[0] - margin, table.x[1] + margin);
  part.keep_between(first.at_in_base.y(), step.y(), table.y[0] - margin, table.y[1] + margin);
  part.keep_between(first.at_in_base.z(), step.z(), -std::numeric_limits<double>::max(), table.top + margin);
  return part.from < part.to;
}

std::string at_height(const StandingFeature& feature) {
  return fmt::format("the feature {} is at a height of {:.1f} mm", in_quotes(feature.name), feature.at_in_base.z());
}

std::string bad_height(const Stand& stand, const StandingFeature& feature) {
  const double height = feature.at_in_base.z();
  if (stand.floor && height - feature.radius < *stand.floor) {
    return fmt::format("{}{}, which reaches below the floor at {:.1f} mm", at_height(feature),
                       feature.radius > 0.0 ? fmt::format(" with a radius of {:.1f} mm", feature.radius) : "",
                       *stand.floor);
  }
  if (stand.lowest && height < *stand.lowest) {
    return fmt::format("{}, below the lowest that the stand holds, {:.1f} mm", at_height(feature), *stand.lowest);
  }
  if (stand.highest && height > *stand.highest) {
    return fmt::format("{}, above the highest that the stand holds, {:.1f} mm", at_height(feature), *stand.highest);
  }
  return {};
}

}  // namespace

std::string not_held(const Stand& stand, const std::vector<StandingFeature>& features) {
  for (const StandingFeature& feature : features) {
    if (std::string reason = bad_height(stand, feature); !reason.empty()) {
      return reason;
    }
  }
  for (const Obstacle& table : stand.tables) {
    for (std::size_t i = 0; i < features.size(); ++i) {
      for (std::size_t j = i; j < features.size(); ++j) {
        if (goes_into(table, features[i], features[j])) {
          return fmt::format(
              "the artefact goes into the table with its top at {:.1f} mm, between its features {} and {}", table.top,
              in_quotes(features[i].name), in_quotes(features[j].name));
        }
      }
    }
  }
  return {};
}

}  // namespace artcal
