#include "identification/problem/certified_distances.h"

#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace artcal {

std::vector<int> certified_distances(const Constraints& constraints) {
  std::map<std::tuple<int, int, int>, int> index;  // artefact, its two features
  int count = 0;
  for (std::size_t a = 0; a < constraints.artefacts.size(); ++a) {
    for (const CertifiedDistance& distance : constraints.artefacts[a].distances) {
      index[{static_cast<int>(a), distance.first, distance.second}] = count++;
    }
  }
  std::vector<int> certificates;
  for (const DistanceConstraint& distance : constraints.distances) {
    const FeatureConstraint& first = constraints.features[distance.first];
    const auto found = index.find({first.artefact, first.feature, constraints.features[distance.second].feature});
    certificates.push_back(found == index.end() ? -1 : found->second);
  }
  return certificates;
}

std::vector<double> above_reference(const Constraints& constraints, const Recording& recording) {
  std::map<std::pair<int, int>, std::pair<double, int>> sums;  // by artefact and placement
  for (const FeatureConstraint& feature : constraints.features) {
    auto& [sum, count] = sums[{feature.artefact, feature.placement}];
    for (const int reading : feature.readings) {
      const double temperature = recording.readings[reading].temperature;
      if (std::isfinite(temperature)) {
        sum += temperature - constraints.artefacts[feature.artefact].reference_temperature;
        ++count;
      }
    }
  }
  std::vector<double> above;
  for (const FeatureConstraint& feature : constraints.features) {
    const auto& [sum, count] = sums[{feature.artefact, feature.placement}];
    above.push_back(count > 0 ? sum / count : 0.0);
  }
  return above;
}

}  // namespace artcal
