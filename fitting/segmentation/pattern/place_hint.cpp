#include "fitting/segmentation/pattern/place_hint.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fitting/segmentation/pattern/match.h"

namespace artcal {
namespace {

int nearest_to(const Eigen::Vector3d& place, const std::vector<FoundPoint>& found) {
  const auto nearer = [&](const FoundPoint& a, const FoundPoint& b) {
    return (a.at - place).norm() < (b.at - place).norm();
  };
  const auto nearest = std::min_element(found.begin(), found.end(), nearer);
  return nearest == found.end() ? -1 : static_cast<int>(nearest - found.begin());
}

}  // namespace

double place_limit(const Pattern& pattern, int point) {
  double limit = pattern.radii[static_cast<std::size_t>(point)] + pattern.tolerance;
  for (Eigen::Index other = 0; other < pattern.distances.cols(); ++other) {
    const double distance = pattern.distances(point, other);
    if (other != point && std::isfinite(distance) && distance > 0.0) {
      limit = std::min(limit, 0.5 * distance);
    }
  }
  return limit;
}

ResolvedHints resolve_hints(const Pattern& pattern, const std::vector<FoundPoint>& found,
                            const std::vector<PlaceHint>& hints) {
  ResolvedHints resolved{std::vector<int>(pattern.radii.size(), -1), {}};
  for (std::size_t i = 0; i < hints.size(); ++i) {
    const PlaceHint& hint = hints[i];
    UnmetHint unmet{static_cast<int>(i), UnmetHint::Fault::NothingNear, nearest_to(hint.near, found), 0.0,
                    place_limit(pattern, hint.point)};
    auto& answer = resolved.found[static_cast<std::size_t>(hint.point)];
    if (unmet.nearest < 0) {
      resolved.unmet.push_back(unmet);
      continue;
    }
    const FoundPoint& nearest = found[static_cast<std::size_t>(unmet.nearest)];
    const double radius = pattern.radii[static_cast<std::size_t>(hint.point)];
    unmet.distance = (nearest.at - hint.near).norm();
    const bool stated_before =
        std::find(resolved.found.begin(), resolved.found.end(), unmet.nearest) != resolved.found.end() || answer >= 0;
    if (unmet.distance > unmet.limit) {
      resolved.unmet.push_back(unmet);
    } else if (std::abs(nearest.radius - radius) > 1e-9 * radius) {
      unmet.fault = UnmetHint::Fault::OtherRadius;
      resolved.unmet.push_back(unmet);
    } else if (stated_before && answer != unmet.nearest) {
      unmet.fault = UnmetHint::Fault::SameAsOther;
      resolved.unmet.push_back(unmet);
    } else {
      answer = unmet.nearest;
    }
  }
  return resolved;
}

std::string fault_text(const UnmetHint& unmet) {
  switch (unmet.fault) {
    case UnmetHint::Fault::OtherRadius: return "the sphere found there has another certified radius";
    case UnmetHint::Fault::SameAsOther: return "two statements contradict each other there";
    case UnmetHint::Fault::NothingNear: break;
  }
  return unmet.nearest < 0 ? fmt::format("no sphere was found within {:.4g} mm of it", unmet.limit)
                           : fmt::format("no sphere was found within {:.4g} mm of it, the nearest is {:.4g} mm away",
                                         unmet.limit, unmet.distance);
}

}  // namespace artcal
