#include "app/results/verification/feature_places.h"

#include <set>
#include <tuple>

#include "artefacts/verification/measured.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Eigen::Vector3d mean_tip(const Session& session, const std::vector<int>& readings) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int reading : readings) {
    sum += session.tips.in_base.col(reading);
  }
  return sum / static_cast<double>(readings.size());
}

}  // namespace

Json feature_places_json(const Session& session) {
  Json places = Json::array();
  std::set<std::tuple<int, int, int>> known;
  for (const Touched& touched : touched_features(session, Orientations::Together)) {
    if (!known.emplace(touched.artefact, touched.placement, touched.feature).second) {
      continue;
    }
    const Artefact& artefact = session.constraints.artefacts[static_cast<std::size_t>(touched.artefact)];
    const auto measured = measure(session, touched);
    const Eigen::Vector3d at = measured ? measured->centre_in_base : mean_tip(session, touched.readings);
    places.push_back({{"artefact", artefact.name},
                      {"placement", session.recording.placements.name(touched.placement)},
                      {"feature", artefact.features[static_cast<std::size_t>(touched.feature)].name},
                      {"at_mm", {at.x(), at.y(), at.z()}}});
  }
  return places;
}

}  // namespace artcal
