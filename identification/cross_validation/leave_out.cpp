#include "identification/cross_validation/leave_out.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "core/parallel.h"
#include "identification/cross_validation/checked_predictions.h"
#include "identification/least_squares/evaluation_of_system.h"

namespace artcal {
namespace {

using Place = std::pair<int, int>;  // artefact, placement

std::vector<Place> places_read(const Constraints& constraints) {
  std::vector<Place> places;
  std::set<Place> seen;
  for (const auto& feature : constraints.features) {
    const Place place{feature.artefact, feature.placement};
    if (seen.insert(place).second) {
      places.push_back(place);
    }
  }
  return places;
}

void refuse(LeftOut& result, const Error& error) {
  result.refusal = error.text();
  result.refusal_kind = error.kind;
}

// `system` is of all readings, whose sines do not depend on the arm; what else it holds changes.
LeftOut leave_out(System& system, const Recording& recording, const Constraints& constraints, const Place& place,
                  const LeavingOut& leaving_out) {
  std::vector<bool> is_in_place;
  for (const auto& feature : constraints.features) {
    is_in_place.push_back(Place{feature.artefact, feature.placement} == place);
  }
  LeftOut result;
  result.deviation.name = {constraints.artefacts[place.first].name, recording.placements.name(place.second), ""};
  auto refit = leaving_out.refit ? leaving_out.refit(place.first, place.second) : std::nullopt;
  const auto without = refit ? Expected<ArmWithout>(std::move(*refit))
                             : leaving_out.identify(without_features(constraints, is_in_place));
  if (!without) {
    refuse(result, without.error());
    return result;
  }
  is_in_place.flip();
  const Constraints placement = without_features(constraints, is_in_place);
  system.constraints = &placement;
  system.start = without->arm;
  system.free.clear();
  system.scale.resize(0);
  const auto judged = evaluate(system, recording);
  if (!judged) {
    refuse(result, judged.error());
    return result;
  }
  result.deviation = judged->placements.front();
  result.lengths = judged->lengths;
  std::set<int> groups;
  for (std::size_t f = 0; f < placement.features.size(); ++f) {
    const FeatureDeviation& deviation = judged->features[f];
    result.squares += deviation.readings * deviation.rms * deviation.rms;
    result.degrees_of_freedom += placement.features[f].size() * placement.features[f].dimension();
    const auto group = placement.features[f].group;
    if (group && groups.insert(*group).second) {
      result.degrees_of_freedom -= placement.groups[*group].size;
    }
  }
  if (without->sources.covariance.size() > 0) {
    result.predictions = check_predictions(recording, placement, *judged, without->arm, without->sources);
  }
  return result;
}

}  // namespace

std::vector<LeftOut> leave_placements_out(const System& readings, const Recording& recording,
                                          const Constraints& constraints, const LeavingOut& leaving_out) {
  const auto places = places_read(constraints);
  if (places.size() < 2) {
    return {};
  }
  std::vector<LeftOut> results(places.size());
  std::mutex counting;
  std::size_t done = 0;
  std::atomic<std::size_t> next = 0;
  on_threads(thread_count(leaving_out.threads, places.size()), [&] {
    System system = readings;  // a copy a thread: it is as large as the recording
    for (std::size_t i = next++; i < places.size(); i = next++) {
      results[i] = leave_out(system, recording, constraints, places[i], leaving_out);
      if (leaving_out.progress) {
        const std::lock_guard lock(counting);
        leaving_out.progress("leave-one-placement-out cross-validation", ++done, places.size());
      }
    }
  });
  return results;
}

}  // namespace artcal
