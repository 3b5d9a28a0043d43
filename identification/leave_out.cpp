#include "identification/leave_out.h"

#include <algorithm>
#include <utility>

#include "core/parallel.h"

namespace artcal {
namespace {

using Place = std::pair<int, int>;  // artefact, placement

std::vector<Place> places_of(const Constraints& constraints) {
  std::vector<Place> places;
  for (const auto& feature : constraints.features) {
    const Place place{feature.artefact, feature.placement};
    if (std::find(places.begin(), places.end(), place) == places.end()) {
      places.push_back(place);
    }
  }
  return places;
}

LeftOut leave_out(const Recording& recording, const Constraints& constraints, const Place& place,
                  const IdentifyWithout& identify_without) {
  std::vector<bool> is_in_place;
  for (const auto& feature : constraints.features) {
    is_in_place.push_back(Place{feature.artefact, feature.placement} == place);
  }
  LeftOut result;
  result.deviation.name = {constraints.artefacts[place.first].name, recording.placements.name(place.second), ""};
  const auto arm = identify_without(without_features(constraints, is_in_place));
  if (!arm) {
    result.refusal = arm.error().text();
    return result;
  }
  is_in_place.flip();
  const auto judged = evaluate(recording, without_features(constraints, is_in_place), *arm);
  if (!judged) {
    result.refusal = judged.error().text();
    return result;
  }
  result.deviation = judged->placements.front();
  result.lengths = judged->lengths;
  return result;
}

}  // namespace

std::vector<LeftOut> leave_placements_out(const Recording& recording, const Constraints& constraints,
                                          const IdentifyWithout& identify_without, int threads) {
  const auto places = places_of(constraints);
  if (places.size() < 2) {
    return {};
  }
  std::vector<LeftOut> results(places.size());
  parallel_for(places.size(), threads,
               [&](std::size_t i) { results[i] = leave_out(recording, constraints, places[i], identify_without); });
  return results;
}

}  // namespace artcal
