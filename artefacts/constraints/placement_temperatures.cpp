#include "artefacts/constraints/placement_temperatures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

bool has_certified_lengths(const Artefact& artefact) {
  return !artefact.distances.empty() ||
         std::any_of(artefact.features.begin(), artefact.features.end(),
                     [](const CertifiedFeature& feature) { return feature.at || feature.radius; });
}

}  // namespace

PlacementTemperatures placement_temperatures(const Recording& recording, const std::vector<int>& artefact_of,
                                             const std::vector<Artefact>& artefacts) {
  std::map<std::pair<int, int>, std::pair<double, int>> sums;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    auto& [sum, count] = sums[{artefact_of[i], recording.readings[i].placement}];
    if (std::isfinite(recording.readings[i].temperature)) {
      sum += recording.readings[i].temperature;
      ++count;
    }
  }
  PlacementTemperatures means;
  for (const auto& [key, entry] : sums) {
    const auto& [sum, count] = entry;
    means[key] = count > 0 ? sum / count : artefacts[key.first].reference_temperature;
  }
  return means;
}

void warn_of_temperatures(Constraints& constraints, const PlacementTemperatures& temperatures) {
  for (std::size_t i = 0; i < constraints.artefacts.size(); ++i) {
    const Artefact& artefact = constraints.artefacts[i];
    double worst = 0.0;
    for (const auto& [key, mean] : temperatures) {
      if (key.first == static_cast<int>(i)) {
        worst = std::max(worst, std::abs(mean - artefact.reference_temperature));
      }
    }
    if (worst > 0.5 && !artefact.expansion_is_known && has_certified_lengths(artefact)) {
      constraints.warnings.push_back(
          fmt::format("the artefact {} was used {:.1f} K away from {} degC, but its file states no "
                      "expansion_per_K: its lengths were not corrected",
                      in_quotes(artefact.name), worst, artefact.reference_temperature));
    }
  }
}

}  // namespace artcal
