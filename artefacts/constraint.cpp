#include "artefacts/constraint.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

#include "artefacts/artefact_file.h"
#include "artefacts/certificate.h"
#include "artefacts/scan_readings.h"
#include "artefacts/unknowns.h"
#include "core/in_quotes.h"

namespace artcal {
namespace {

using Key = std::tuple<int, int, int>;   // artefact, placement, feature
constexpr double parallel = 0.99999;     // cosine: normals are certified to a quarter of a degree at the worst
constexpr std::size_t most_known = 200;  // characters of a list in a message: a step gauge has many features

Location location_of(const Artefact& artefact, const CertifiedFeature& feature) {
  if (!feature.at && feature.kind != FeatureKind::Coordinates) {
    return Location::Unknown;
  }
  return artefact.frame == CoordinateFrame::Base ? Location::Base : Location::Posed;
}

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
    if (first.normal && second.normal && std::abs(first.normal->dot(*second.normal)) < parallel) {
      return told("lies between planes that are not parallel");
    }
  }
  return {};
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
  return bad_input(
      name.empty() ? fmt::format("the reading names no artefact, and there are several: {}", at_most(most_known, known))
                   : fmt::format("the reading names the artefact {}, expected one of: {}", in_quotes(name),
                                 at_most(most_known, known)),
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
                                     in_quotes(artefact.name), at_most(most_known, known))
                       : fmt::format("the reading names the feature {}, which the artefact {} does not have, expected "
                                     "one of: {}",
                                     in_quotes(name), in_quotes(artefact.name), at_most(most_known, known)),
                   recording.where(reading));
}

Demand demand_of(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::Sphere: return Demand::OnBall;
    case FeatureKind::Plane: return Demand::OnPlane;
    case FeatureKind::Anchor: return Demand::AtDistance;
    default: return Demand::Coincide;
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
    constraint.distances.push_back(reading.length);
  }
  return {};
}

// Mean temperature of an artefact's readings in a placement; the reference where none was read.
std::map<std::pair<int, int>, double> temperatures(const Recording& recording, const std::vector<int>& artefact_of,
                                                   const std::vector<Artefact>& artefacts) {
  std::map<std::pair<int, int>, std::pair<double, int>> sums;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    auto& [sum, count] = sums[{artefact_of[i], recording.readings[i].placement}];
    if (std::isfinite(recording.readings[i].temperature)) {
      sum += recording.readings[i].temperature;
      ++count;
    }
  }
  std::map<std::pair<int, int>, double> means;
  for (const auto& [key, entry] : sums) {
    const auto& [sum, count] = entry;
    means[key] = count > 0 ? sum / count : artefacts[key.first].reference_temperature;
  }
  return means;
}

bool has_certified_lengths(const Artefact& artefact) {
  return !artefact.distances.empty() ||
         std::any_of(artefact.features.begin(), artefact.features.end(),
                     [](const CertifiedFeature& feature) { return feature.at || feature.radius; });
}

void warn_of_temperatures(Constraints& constraints, const std::map<std::pair<int, int>, double>& means) {
  for (std::size_t i = 0; i < constraints.artefacts.size(); ++i) {
    const Artefact& artefact = constraints.artefacts[i];
    double worst = 0.0;
    for (const auto& [key, mean] : means) {
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

// The certificate's, and at another temperature that of the expansion.
double uncertainty_at(const CertifiedDistance& distance, const Artefact& artefact, double temperature) {
  return std::hypot(distance.u, distance.value * (temperature - artefact.reference_temperature) * artefact.u_expansion);
}

void add_distances(Constraints& constraints, const std::map<Key, int>& index,
                   const std::map<std::pair<int, int>, double>& means) {
  for (const auto& [place, temperature] : means) {
    const Artefact& artefact = constraints.artefacts[place.first];
    for (const CertifiedDistance& distance : artefact.distances) {
      const auto first = index.find({place.first, place.second, distance.first});
      const auto second = index.find({place.first, place.second, distance.second});
      if (first == index.end() || second == index.end()) {
        continue;
      }
      constraints.distances.push_back({first->second, second->second,
                                       distance.value * artefact.expansion_factor(temperature),
                                       uncertainty_at(distance, artefact, temperature)});
    }
  }
}

}  // namespace

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
  const auto means = temperatures(recording, artefact_of, constraints.artefacts);
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
      added.demand = demand_of(feature.kind);
      added.u = feature.u;
      added.expansion = artefact.expansion_factor(means.at({a, placement}));
      added.normal = feature.normal.value_or(Eigen::Vector3d::Zero());
      added.radius = added.expansion * feature.radius.value_or(0.0);
    }
    if (auto read = add_reading(constraints.features[entry->second], recording, i, feature); !read) {
      return tl::unexpected(read.error());
    }
  }
  add_distances(constraints, index, means);
  warn_of_temperatures(constraints, means);
  for (auto& warning : certificate_warnings(constraints.artefacts, recording.date)) {
    constraints.warnings.push_back(std::move(warning));
  }
  assign_unknowns(constraints);
  return constraints;
}

Expected<Constraints> read_constraints(Recording& recording) { return read_constraints(recording, ScanSelection{}); }

Expected<Constraints> read_constraints(Recording& recording, const ScanSelection& selection) {
  if (recording.artefact_paths.empty()) {
    return bad_input("the recording names no artefact, expected artefacts = [\"artefact.toml\"]",
                     recording.inputs.empty() ? "" : recording.inputs.front().path);
  }
  std::vector<Artefact> artefacts;
  for (const auto& path : recording.artefact_paths) {
    auto file = read_artefact_file(path);
    if (!file) {
      return tl::unexpected(file.error());
    }
    for (const auto& other : artefacts) {
      if (other.name == file->artefact.name) {
        return bad_input(fmt::format("two artefacts of this recording are called {}", in_quotes(other.name)), path);
      }
    }
    recording.inputs.push_back(file->input);
    if (file->certificate) {
      recording.inputs.push_back(*file->certificate);
    }
    artefacts.push_back(std::move(file->artefact));
  }
  if (auto read = read_scans(recording, artefacts, selection); !read) {
    return tl::unexpected(read.error());
  }
  return build_constraints(recording, std::move(artefacts));
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

Constraints balls_as_points(Constraints constraints) {
  for (auto& feature : constraints.features) {
    if (feature.demand == Demand::OnBall) {
      feature.demand = Demand::Coincide;
    }
  }
  assign_unknowns(constraints);
  return constraints;
}

}  // namespace artcal
