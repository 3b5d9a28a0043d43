#include "identification/uncertainty/influence.h"

namespace artcal {

std::vector<ArtefactInfluence> influences_of(const Constraints& constraints, const ArmFit& fit,
                                             const Redundancy& redundancy) {
  std::vector<ArtefactInfluence> influences(constraints.artefacts.size());
  double all = 0.0;
  const auto add = [&](int artefact, double weight, const Check& check, int ArtefactInfluence::*count,
                       double ArtefactInfluence::*sum) {
    ArtefactInfluence& influence = influences[static_cast<std::size_t>(artefact)];
    ++(influence.*count);
    influence.*sum += weight;
    influence.share += check.influence;
    all += check.influence;
  };
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    for (std::size_t k = 0; k < redundancy.readings[f].size(); ++k) {
      add(feature.artefact, fit.loss_weights.readings[f][k], redundancy.readings[f][k], &ArtefactInfluence::readings,
          &ArtefactInfluence::readings_weight);
    }
  }
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    if (constraints.distances[d].binds) {
      add(constraints.features[constraints.distances[d].first].artefact, fit.loss_weights.distances[d],
          redundancy.distances[d], &ArtefactInfluence::certificates, &ArtefactInfluence::certificates_weight);
    }
  }
  for (std::size_t s = 0; s < constraints.shared.size(); ++s) {
    if (constraints.shared[s].u > 0.0) {
      add(constraints.shared[s].artefact, fit.loss_weights.shared[s], redundancy.shared[s],
          &ArtefactInfluence::certificates, &ArtefactInfluence::certificates_weight);
    }
  }
  for (std::size_t a = 0; a < influences.size(); ++a) {
    ArtefactInfluence& influence = influences[a];
    influence.artefact = constraints.artefacts[a].name;
    influence.readings_weight /= std::max(1, influence.readings);
    influence.certificates_weight /= std::max(1, influence.certificates);
    influence.share = all > 0.0 ? influence.share / all : 0.0;
  }
  std::erase_if(influences, [](const ArtefactInfluence& influence) { return influence.readings == 0; });
  return influences;
}

}  // namespace artcal
