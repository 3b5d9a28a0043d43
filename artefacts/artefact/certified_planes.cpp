#include "artefacts/artefact/certified_planes.h"

#include <fmt/format.h>

#include "artefacts/artefact/parallel.h"
#include "core/text/in_quotes.h"

namespace artcal {

Expected<void> check_planes(const Artefact& artefact) {
  for (const CertifiedFeature& feature : artefact.features) {
    if (feature.kind == FeatureKind::Plane && feature.at && !feature.normal) {
      return bad_input(fmt::format("the plane {} of the artefact {} has a certified place but no certified normal",
                                   in_quotes(feature.name), in_quotes(artefact.name)));
    }
  }
  for (const CertifiedDistance& distance : artefact.distances) {
    const CertifiedFeature& first = artefact.features[distance.first];
    const CertifiedFeature& second = artefact.features[distance.second];
    const auto told = [&](const char* why) {
      return bad_input(fmt::format("the distance between {} and {} of the artefact {} {}", in_quotes(first.name),
                                   in_quotes(second.name), in_quotes(artefact.name), why));
    };
    if ((first.kind == FeatureKind::Plane) != (second.kind == FeatureKind::Plane)) {
      return told("lies between a plane and something else, expected two points or centres, or two parallel planes");
    }
    if (first.normal && second.normal && !are_parallel(*first.normal, *second.normal)) {
      return told("lies between planes that are not parallel");
    }
  }
  return {};
}

}  // namespace artcal
