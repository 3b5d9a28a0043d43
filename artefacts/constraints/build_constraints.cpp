#include "artefacts/constraints/constraint.h"

#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "artefacts/artefact/certified_planes.h"
#include "artefacts/constraints/placement_temperatures.h"
#include "artefacts/constraints/unknowns.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Key = std::tuple<int, int, int>;  // artefact, placement, feature
constexpr std::size_t max_known = 200;  // characters of a list in a message: a step gauge has many features

Location location_of(const Artefact& artefact, const CertifiedFeature& feature) {
  if (!feature.at && feature.kind != FeatureKind::Coordinates) {
    return Location::Unknown;
  }
  return artefact.frame == CoordinateFrame::Base ? Location::Base : Location::Posed;
}

Expected<int> find_artefact(const Recording& recording, int reading, const std::vector<Artefact>& artefacts) {
  const auto& name = recording.artefacts.name(recording.readings[reading].artefact);
  std::string known;
  for (std::size_t i = 0; i < artefacts.size(); ++i) {
    if (artefacts[i].name == name || (name.empty() && artefacts.size() == 1)) {
      return static_cast<int>(i);
    }
    known += (i == 0 ? "" : ", ") + artefacts[i].name;
  }
  return bad_input(name.empty() ? fmt::format("the reading names no artefact, and there are several: {}",
                                              truncated(max_known, known))
                                : fmt::format("the reading names the artefact {}, expected one of: {}", in_quotes(name),
                                              truncated(max_known, known)),
                   recording.where(reading));
}

Expected<int> find_feature(const Recording& recording, int reading, const Artefact& artefact) {
  const auto& name = recording.features.name(recording.readings[reading].feature);
  const int index = artefact.feature_index(name);
  if (index >= 0) {
    return index;
  }
  std::string known;
  for (const auto& feature : artefact.features) {
    known += (known.empty() ? "" : ", ") + feature.name;
  }
  return bad_input(name.empty()
                       ? fmt::format("the reading names no feature, expected one of the artefact {}: {}",
                                     in_quotes(artefact.name), truncated(max_known, known))
                       : fmt::format("the reading names the feature {}, which the artefact {} does not have, expected "
                                     "one of: {}",
                                     in_quotes(name), in_quotes(artefact.name), truncated(max_known, known)),
                   recording.where(reading));
}

ConstraintKind kind_of(const CertifiedFeature& feature, double expansion) {
  switch (feature.kind) {
    case FeatureKind::Sphere: return OnBall{feature.radius ? std::optional(expansion * *feature.radius) : std::nullopt};
    case FeatureKind::Plane: return OnPlane{feature.normal};
    case FeatureKind::Anchor: return AtDistance{};
    default: return Coincide{};
  }
}

// Adds what one reading brings of its own.
Expected<void> add_reading(FeatureConstraint& constraint, const Recording& recording, int index,
                           const CertifiedFeature& feature) {
  const Reading& reading = recording.readings[index];
  constraint.readings.push_back(index);
  if (feature.kind == FeatureKind::Coordinates) {
    if (!reading.reference.allFinite()) {
      return bad_input(fmt::format("the feature {} wants the tip's coordinates with each reading, but ref_x, ref_y, "
                                   "ref_z are missing here",
                                   in_quotes(feature.name)),
                       recording.where(index));
    }
    constraint.known.emplace_back(reading.reference);
  } else if (feature.at) {
    constraint.known.emplace_back(constraint.expansion * *feature.at);
  }
  if (feature.kind == FeatureKind::Anchor) {
    if (!(reading.length > 0.0)) {
      return bad_input(fmt::format("the feature {} is an anchor to which a length is measured, expected a number "
                                   "above zero in the column length",
                                   in_quotes(feature.name)),
                       recording.where(index));
    }
    constraint.as<AtDistance>()->distances.push_back(reading.length);
  }
  return {};
}

// The certificate's, and at another temperature that of the expansion.
double uncertainty_at(const CertifiedDistance& distance, const Artefact& artefact, double temperature) {
  return std::hypot(distance.u, distance.value * (temperature - artefact.reference_temperature) * artefact.u_expansion);
}

void add_distances(Constraints& constraints, const std::map<Key, int>& index, const PlacementTemperatures& means) {
  for (const auto& [place, temperature] : means) {
    const Artefact& artefact = constraints.artefacts[place.first];
    for (const CertifiedDistance& distance : artefact.distances) {
      const auto first = index.find({place.first, place.second, distance.first});
      const auto second = index.find({place.first, place.second, distance.second});
      if (first == index.end() || second == index.end()) {
        continue;
      }
      constraints.distances.push_back(
          {first->second, second->second, distance.value * artefact.expansion_factor(temperature),
           uncertainty_at(distance, artefact, temperature), true, artefact.stated(distance)});
    }
  }
}

}  // namespace

Expected<Constraints> build_constraints(const Recording& recording, std::vector<Artefact> artefacts) {
  for (const Artefact& artefact : artefacts) {
    if (auto sound = check_planes(artefact); !sound) {
      return tl::unexpected(sound.error());
    }
  }
  Constraints constraints;
  constraints.artefacts = std::move(artefacts);
  std::vector<int> artefact_of(recording.readings.size());
  for (int i = 0; i < static_cast<int>(recording.readings.size()); ++i) {
    const auto artefact = find_artefact(recording, i, constraints.artefacts);
    if (!artefact) {
      return tl::unexpected(artefact.error());
    }
    artefact_of[i] = *artefact;
  }
  const auto means = placement_temperatures(recording, artefact_of, constraints.artefacts);
  std::map<Key, int> index;
  for (int i = 0; i < static_cast<int>(recording.readings.size()); ++i) {
    const int a = artefact_of[i];
    const int placement = recording.readings[i].placement;
    const Artefact& artefact = constraints.artefacts[a];
    const auto f = find_feature(recording, i, artefact);
    if (!f) {
      return tl::unexpected(f.error());
    }
    const CertifiedFeature& feature = artefact.features[*f];
    const auto [entry, is_new] =
        index.try_emplace(Key{a, placement, *f}, static_cast<int>(constraints.features.size()));
    if (is_new) {
      auto& added = constraints.features.emplace_back();
      added.artefact = a;
      added.placement = placement;
      added.feature = *f;
      added.location = location_of(artefact, feature);
      added.u = feature.u;
      added.expansion = artefact.expansion_factor(means.at({a, placement}));
      added.kind = kind_of(feature, added.expansion);
    }
    if (auto read = add_reading(constraints.features[entry->second], recording, i, feature); !read) {
      return tl::unexpected(read.error());
    }
  }
  add_distances(constraints, index, means);
  warn_of_temperatures(constraints, means);
  assign_unknowns(constraints);
  return constraints;
}

}  // namespace artcal
