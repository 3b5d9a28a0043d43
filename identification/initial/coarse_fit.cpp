#include "identification/initial/coarse_fit.h"

#include <algorithm>
#include <map>
#include <utility>

#include "identification/problem/weights.h"

namespace artcal {
namespace {

// Of a centre taken to lie along the stylus or at the tip, as a share of both radii.
constexpr double centre_scatter = 0.5;
constexpr double ball_of_unknown_size = 12.7;  // mm

}  // namespace

double distance_to_centre(const OnBall& ball, double tip_radius) {
  return tip_radius + ball.radius.value_or(ball_of_unknown_size);
}

void lengthen_to_centres(const Constraints& constraints, System& system) {
  std::map<std::pair<int, double>, int> made;
  for (const FeatureConstraint& feature : constraints.features) {
    const auto* ball = feature.as<OnBall>();
    for (int k = 0; ball != nullptr && k < feature.size(); ++k) {
      int& probe = system.probes[feature.readings[k]];
      auto& probes = system.start.probes;
      const double beyond = distance_to_centre(*ball, probes[probe].radius);
      const auto [entry, is_new] = made.try_emplace({probe, beyond}, static_cast<int>(probes.size()));
      if (is_new) {
        Probe longer = probes[probe];
        const double length = longer.tip_in_last.norm();
        longer.tip_in_last +=
            beyond * (length > 0.0 ? Eigen::Vector3d(longer.tip_in_last / length) : Eigen::Vector3d::UnitZ());
        probes.push_back(std::move(longer));
      }
      probe = entry->second;
    }
  }
}

double centre_deviation(const Constraints& constraints, const Arm& arm) {
  double largest = 0.0;
  for (const FeatureConstraint& feature : constraints.features) {
    const auto* ball = feature.as<OnBall>();
    largest = std::max(largest, ball != nullptr ? distance_to_centre(*ball, arm.probes.front().radius) : 0.0);
  }
  return std::max(1.0, centre_scatter * largest);
}

Weights coarse_weights(const Constraints& constraints, double sigma) {
  Weights weights = uniform_weights(constraints, sigma);
  const Weights unit = unit_weights(constraints);
  for (std::size_t d = 0; d < weights.distances.size(); ++d) {
    weights.distances[d] = std::min(weights.distances[d], unit.distances[d] / sigma);
  }
  for (std::size_t s = 0; s < weights.shared.size(); ++s) {
    weights.shared[s] = std::min(weights.shared[s], unit.shared[s] / sigma);
  }
  return weights;
}

}  // namespace artcal
