#include "artefacts/constraints/unknowns.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "artefacts/artefact/parallel.h"

namespace artcal {
namespace {

constexpr double steepest_wedge = 0.0872;  // sine of 5 degrees
// Points nearer to a line than this, mm, are on it: readings of an arm do not show a micrometre, and a turn that they
// do not show is no unknown.
constexpr double on_the_line = 1e-3;
// Points whose distance from a line is less than this share of its length are nearly on it.
constexpr double nearly_straight = 0.05;

const CertifiedFeature& certified(const FeatureConstraint& feature, const Constraints& constraints) {
  return constraints.artefacts[feature.artefact].features[feature.feature];
}

// Its place in the group is its own.
bool is_free(const FeatureConstraint& feature) {
  return feature.location == Location::Unknown && feature.face() == nullptr;
}

/// What was read of an artefact in one placement.
struct Seen {
  std::vector<Eigen::Vector3d> directions;  ///< of its planes, each class of parallel ones once
  bool only_planes = true;
};

// The class of parallel planes that this one belongs to; nothing where it is the first of its class.
const Eigen::Vector3d* direction_of(const OnPlane& plane, const Seen& seen) {
  const auto found = std::find_if(seen.directions.begin(), seen.directions.end(),
                                  [&](const Eigen::Vector3d& other) { return are_parallel(other, *plane.normal); });
  return found == seen.directions.end() ? nullptr : &*found;
}

// Whether all planes face along one axis, exactly (a gauge) or nearly (a wedge): such planes do not determine a pose.
bool face_along_one_axis(const std::vector<Eigen::Vector3d>& normals) {
  return std::all_of(normals.begin(), normals.end(), [&](const Eigen::Vector3d& normal) {
    return normal.cross(normals.front()).norm() < steepest_wedge;
  });
}

// Finds the artefacts of which only such planes were read in a placement. Each class of parallel planes is then a gauge
// of its own: the faces of a wedge keep the normals that are certified, and no pose is asked of them.
void find_gauges(Constraints& constraints) {
  const auto place_of = [](const FeatureConstraint& feature) { return std::pair{feature.artefact, feature.placement}; };
  std::map<std::pair<int, int>, Seen> placements;
  for (auto& feature : constraints.features) {
    auto* plane = feature.as<OnPlane>();
    if (plane != nullptr && plane->face) {  // found with other readings beside it
      feature.location = Location::Posed;
      plane->face.reset();
      plane->normal = certified(feature, constraints).normal;
    }
    if (feature.location != Location::Posed) {
      continue;
    }
    Seen& seen = placements[place_of(feature)];
    seen.only_planes &= plane != nullptr;
    if (plane != nullptr && direction_of(*plane, seen) == nullptr) {
      seen.directions.push_back(*plane->normal);
    }
  }
  for (auto& feature : constraints.features) {
    if (feature.location != Location::Posed) {
      continue;
    }
    const Seen& seen = placements.at(place_of(feature));
    if (seen.only_planes && face_along_one_axis(seen.directions)) {
      auto& plane = std::get<OnPlane>(feature.kind);
      const Eigen::Vector3d axis = *direction_of(plane, seen);
      feature.location = Location::Unknown;
      plane.face = GaugeFace{plane.normal->dot(axis) < 0.0 ? -1.0 : 1.0, axis.dot(feature.known.front())};
      plane.normal = plane.face->facing * axis;
    }
  }
}

int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    i = parent[i] = parent[parent[i]];
  }
  return i;
}

// The axis of a gauge, of one of its faces; zero of what has a pose.
Eigen::Vector3d axis_of(const FeatureConstraint& feature) {
  const GaugeFace* face = feature.face();
  if (face == nullptr) {
    return Eigen::Vector3d::Zero();
  }
  return face->facing * *feature.as<OnPlane>()->normal;
}

// Unknowns are grouped by what ties them together: a distance between two points, or one pose.
void assign_groups(Constraints& constraints) {
  std::vector<int> parent(constraints.features.size());
  std::iota(parent.begin(), parent.end(), 0);
  struct First {
    Eigen::Vector3d axis;  // of a gauge; zero: of a pose
    int feature;
  };
  std::map<std::pair<int, int>, std::vector<First>> first_posed;
  for (int i = 0; i < static_cast<int>(parent.size()); ++i) {
    const auto& feature = constraints.features[i];
    if (!is_free(feature) && feature.location != Location::Base) {
      const Eigen::Vector3d axis = axis_of(feature);
      auto& firsts = first_posed[{feature.artefact, feature.placement}];
      const auto first =
          std::find_if(firsts.begin(), firsts.end(), [&](const First& other) { return other.axis == axis; });
      if (first == firsts.end()) {
        firsts.push_back({axis, i});
      } else {
        parent[root_of(parent, i)] = root_of(parent, first->feature);
      }
    }
  }
  for (auto& distance : constraints.distances) {
    distance.binds = is_free(constraints.features[distance.first]) && is_free(constraints.features[distance.second]);
    if (distance.binds) {
      parent[root_of(parent, distance.second)] = root_of(parent, distance.first);
    }
  }
  constraints.groups.clear();
  std::map<int, int> group_of_root;
  for (int i = 0; i < static_cast<int>(parent.size()); ++i) {
    auto& feature = constraints.features[i];
    if (feature.location == Location::Base) {
      feature.group.reset();
      continue;
    }
    const auto [entry, is_new] =
        group_of_root.try_emplace(root_of(parent, i), static_cast<int>(constraints.groups.size()));
    if (is_new) {
      const bool posed = feature.location == Location::Posed;
      const bool tilted = !posed && feature.is<OnPlane>();
      constraints.groups.push_back({posed, tilted, posed ? 6 : tilted ? 2 : 0, PoseTurn::Free, {}});
    }
    feature.group = entry->second;
    auto& group = constraints.groups[entry->second];
    if (feature.location == Location::Unknown) {
      const bool is_face = feature.face() != nullptr;
      feature.offset = is_face ? 2 : group.size;
      if (is_face) {
        group.size = 3;
        continue;
      }
      group.size += feature.is<OnPlane>() ? 1 : 3;
    }
  }
}

// Finds the poses of which only points on a line, or nearly on one, were read, and perhaps planes perpendicular to it.
// Nothing else hangs on such a pose, which is all that the group has.
void find_lines(Constraints& constraints) {
  std::vector<std::vector<const FeatureConstraint*>> posed(constraints.groups.size());
  for (const auto& feature : constraints.features) {
    if (feature.location == Location::Posed) {
      posed[*feature.group].push_back(&feature);
    }
  }
  for (std::size_t g = 0; g < posed.size(); ++g) {
    std::vector<Eigen::Vector3d> points;
    for (const auto* feature : posed[g]) {
      if (!feature->is<OnPlane>()) {
        points.insert(points.end(), feature->known.begin(), feature->known.end());
      }
    }
    if (points.empty()) {
      continue;
    }
    const PointLine line = line_through(points);
    const bool planes_across = std::all_of(posed[g].begin(), posed[g].end(), [&](const FeatureConstraint* feature) {
      const auto* plane = feature->as<OnPlane>();
      return plane == nullptr || are_parallel(*plane->normal, line.artefact_from_line.col(2));
    });
    if (!(line.length > on_the_line) || !(line.straightness < nearly_straight * line.length) || !planes_across) {
      continue;
    }
    constraints.groups[g].line = line;
    if (line.straightness < on_the_line) {
      constraints.groups[g].turn = PoseTurn::Unseen;
      constraints.groups[g].size = 5;
    }
  }
}

bool needs_errors(const FeatureConstraint& feature, const CertifiedFeature& value) {
  return !is_free(feature) && value.at && value.u_at > 0.0;
}

bool needs_radius(const FeatureConstraint& feature, const CertifiedFeature& value) {
  return feature.is<OnBall>() && (!value.radius || value.u_radius > 0.0);
}

// One entry a feature of the artefact, whatever the placements; those of one feature are adjacent.
void assign_shared(Constraints& constraints) {
  using Quantity = ArtefactParameter::Quantity;
  struct Needed {
    bool errors = false, radius = false;
    int first = -1;  // into Constraints::shared
  };
  const auto key_of = [](const FeatureConstraint& feature) { return std::pair{feature.artefact, feature.feature}; };
  std::map<std::pair<int, int>, Needed> needed;
  for (const FeatureConstraint& feature : constraints.features) {
    const CertifiedFeature& value = certified(feature, constraints);
    Needed& of_feature = needed[key_of(feature)];
    of_feature.errors |= needs_errors(feature, value);
    of_feature.radius |= needs_radius(feature, value);
  }
  constraints.shared.clear();
  for (FeatureConstraint& feature : constraints.features) {
    const CertifiedFeature& value = certified(feature, constraints);
    const auto [artefact, index] = key_of(feature);
    Needed& of_feature = needed.at({artefact, index});
    if (of_feature.first < 0) {
      of_feature.first = static_cast<int>(constraints.shared.size());
      if (of_feature.errors) {
        for (const Quantity error : {Quantity::ErrorX, Quantity::ErrorY, Quantity::ErrorZ}) {
          constraints.shared.push_back({artefact, index, error, 0.0, value.u_at});
        }
      }
      if (of_feature.radius) {
        constraints.shared.push_back(
            {artefact, index, Quantity::Radius, value.radius.value_or(0.0), value.radius ? value.u_radius : 0.0});
      }
    }
    feature.first_error = needs_errors(feature, value) ? std::optional(of_feature.first) : std::nullopt;
    if (auto* ball = feature.as<OnBall>()) {
      ball->shared_radius =
          needs_radius(feature, value) ? std::optional(of_feature.first + (of_feature.errors ? 3 : 0)) : std::nullopt;
    }
  }
}

}  // namespace

void assign_unknowns(Constraints& constraints) {
  find_gauges(constraints);
  assign_groups(constraints);
  find_lines(constraints);
  assign_shared(constraints);
}

}  // namespace artcal
