#include "artefacts/constraints/constraint.h"

#include <algorithm>
#include <numeric>

#include "artefacts/constraints/unknowns.h"

namespace artcal {

int Constraints::unknown_count() const {
  return std::accumulate(groups.begin(), groups.end(), static_cast<int>(shared.size()),
                         [](int sum, const auto& group) { return sum + group.size; });
}

int Constraints::reading_residual_count() const {
  return std::accumulate(features.begin(), features.end(), 0,
                         [](int sum, const auto& feature) { return sum + feature.size() * feature.dimension(); });
}

int Constraints::binding_distance_count() const {
  return static_cast<int>(std::count_if(distances.begin(), distances.end(), [](const auto& d) { return d.binds; }));
}

int Constraints::certified_shared_count() const {
  return static_cast<int>(std::count_if(shared.begin(), shared.end(), [](const auto& s) { return s.u > 0.0; }));
}

FeatureName name_of(const FeatureConstraint& constraint, const Constraints& constraints, const Recording& recording) {
  const Artefact& artefact = constraints.artefacts[constraint.artefact];
  return {artefact.name, recording.placements.name(constraint.placement), artefact.features[constraint.feature].name};
}

Constraints without_features(const Constraints& constraints, const std::vector<bool>& drop) {
  Constraints kept{constraints.artefacts, {}, {}, {}, {}, constraints.warnings};
  std::vector<int> new_index(constraints.features.size(), -1);
  for (std::size_t i = 0; i < constraints.features.size(); ++i) {
    if (!drop[i]) {
      new_index[i] = static_cast<int>(kept.features.size());
      kept.features.push_back(constraints.features[i]);
    }
  }
  for (DistanceConstraint distance : constraints.distances) {
    distance.first = new_index[distance.first];
    distance.second = new_index[distance.second];
    if (distance.first >= 0 && distance.second >= 0) {
      kept.distances.push_back(distance);
    }
  }
  assign_unknowns(kept);
  return kept;
}

Constraints with_scaled_turns(Constraints constraints) {
  for (auto& group : constraints.groups) {
    if (group.line && group.turn == PoseTurn::Free) {
      group.turn = PoseTurn::Scaled;
      group.size += 1;
    }
  }
  return constraints;
}

Constraints balls_as_points(Constraints constraints) {
  for (auto& feature : constraints.features) {
    if (feature.is<OnBall>()) {
      feature.kind = Coincide{};
    }
  }
  assign_unknowns(constraints);
  return constraints;
}

}  // namespace artcal
