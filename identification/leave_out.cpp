#include "identification/leave_out.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <utility>

namespace artcal {
namespace {

using Place = std::pair<int, int>;  // artefact, placement

constexpr std::size_t most_threads = 256;

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
  // Plain threads: the thread sanitizer sees all of them, as it does not with Debian's libtbb.
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < places.size(); i = next++) {
      results[i] = leave_out(recording, constraints, places[i], identify_without);
    }
  };
  const auto wanted = threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
  std::vector<std::future<void>> others;
  while (others.size() + 1 < std::min({wanted, places.size(), most_threads})) {
    others.push_back(std::async(std::launch::async, work));
  }
  work();
  for (auto& other : others) {
    other.get();
  }
  return results;
}

}  // namespace artcal
