#include "identification/planning/design_pool.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/overloaded.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/rows.h"
#include "identification/least_squares/triangular_factor.h"
#include "identification/problem/certified_distances.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

/// Where the unknowns of each group stand among those of its placement.
struct Places {
  std::vector<int> of_group;  ///< first column
  std::vector<PossiblePlacement> placements;
  std::map<int, std::size_t> index;  ///< by Recording::placements
};

Places places_of(const Constraints& constraints) {
  Places places;
  places.of_group.assign(constraints.groups.size(), -1);
  for (const FeatureConstraint& feature : constraints.features) {
    const auto [entry, is_new] = places.index.try_emplace(feature.placement, places.placements.size());
    if (is_new) {
      places.placements.emplace_back().placement = feature.placement;
    }
    if (feature.group && places.of_group[*feature.group] < 0) {
      int& unknowns = places.placements[entry->second].unknowns;
      places.of_group[*feature.group] = unknowns;
      unknowns += constraints.groups[*feature.group].size;
    }
  }
  return places;
}

// The rows of every reading of one feature.
void add_readings(const System& system, const FeatureWeights& weights,
                  const std::vector<ForwardKinematics>& kinematics_by_probe, const Unknowns& unknowns, int index,
                  int first_column, int shared, PossiblePlacement& placement) {
  Block block{system.constraints->features[index].group.value_or(-1), 0, {}};
  block.features = {index};
  const int columns = placement.unknowns + shared + system.arm_size();
  const auto add = [&](const FeatureReadings& of) {
    for (int k = 0; k < of.feature.size(); ++k) {
      RowMatrix rows = RowMatrix::Zero(of.feature.dimension(), columns + 1);
      weighted_rows(system, of.feature, weights, kinematics_by_probe, of.residual, k, 1,
                    {rows.cols(), rows.data() + columns, rows.data() + placement.unknowns + shared,
                     block.group < 0 ? nullptr : rows.data() + first_column,
                     system.shared_size() > 0 ? rows.data() + placement.unknowns : nullptr});
      placement.readings.push_back({of.feature.readings[k], index, rows.leftCols(columns)});
    }
  };
  for_each_observation(*system.constraints, block, point_of(block, unknowns),
                       Overloaded{add, [](const BindingDistance&) {}, [](const CertifiedParameter&) {}});
}

/// The errors that certificates bring into every placement alike, and their common columns.
struct CertificateErrors {
  std::vector<int> of_distances;   ///< column of each of Constraints::distances, or -1
  std::vector<int> of_expansions;  ///< the same of its artefact's expansion
  std::vector<std::string> names;

  [[nodiscard]] int size() const { return static_cast<int>(names.size()); }
};

CertificateErrors certificate_errors(const Constraints& constraints) {
  CertificateErrors errors;
  std::map<std::string, int> columns;
  const auto column_of = [&](const std::string& name) {
    const auto [entry, is_new] = columns.try_emplace(name, errors.size());
    if (is_new) {
      errors.names.push_back(name);
    }
    return entry->second;
  };
  for (const DistanceConstraint& distance : constraints.distances) {
    const FeatureConstraint& first = constraints.features[distance.first];
    const Artefact& artefact = constraints.artefacts[first.artefact];
    const auto feature_name = [&](int feature) {
      return artefact.features[constraints.features[feature].feature].name;
    };
    const auto certified =
        std::find_if(artefact.distances.begin(), artefact.distances.end(), [&](const CertifiedDistance& c) {
          return c.first == first.feature && c.second == constraints.features[distance.second].feature;
        });
    const bool is_known = distance.binds && distance.u > 0.0 && certified != artefact.distances.end();
    errors.of_distances.push_back(
        is_known && certified->u > 0.0
            ? column_of(fmt::format("{}: {} - {}, {} mm, u {} mm", artefact.name, feature_name(distance.first),
                                    feature_name(distance.second), certified->value, certified->u))
            : -1);
    errors.of_expansions.push_back(
        is_known && artefact.u_expansion > 0.0
            ? column_of(fmt::format("{}: expansion, u {} 1/K", artefact.name, artefact.u_expansion))
            : -1);
  }
  return errors;
}

// What is left of a certified distance's uncertainty once the common errors are taken out of it: rounding. Not zero,
// because a row of infinite weight cannot be reflected.
constexpr double left_of_a_distance = 1e-3;

void add_distances(const Recording& possible, const Constraints& constraints, const Weights& weights,
                   const Unknowns& unknowns, const CertificateErrors& errors, int first_error, Places& places,
                   int common) {
  const auto above = above_reference(constraints, possible);
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    const DistanceConstraint& distance = constraints.distances[d];
    const FeatureConstraint& first = constraints.features[distance.first];
    if (!distance.binds) {
      continue;
    }
    PossiblePlacement& placement = places.placements[places.index.at(first.placement)];
    Eigen::VectorXd slope(constraints.groups[*first.group].size);
    weighted_distance(distance, constraints, weights.distances[d], unknowns.groups[*first.group].values.data(),
                      slope.data());
    const Eigen::Index row = placement.certified.rows();
    placement.certified.conservativeResize(row + 1, placement.unknowns + common);
    placement.certified.row(row).setZero();
    placement.certified.row(row).segment(places.of_group[*first.group], slope.size()) = slope.transpose();
    const bool has_common_error = errors.of_distances[d] >= 0 || errors.of_expansions[d] >= 0;
    if (errors.of_expansions[d] >= 0) {
      const double u = distance.value * above[distance.first] * constraints.artefacts[first.artefact].u_expansion;
      placement.certified(row, placement.unknowns + first_error + errors.of_expansions[d]) = -weights.distances[d] * u;
    }
    if (errors.of_distances[d] >= 0) {
      const double u_expansion = errors.of_expansions[d] < 0 ? 0.0
                                                             : distance.value * above[distance.first] *
                                                                   constraints.artefacts[first.artefact].u_expansion;
      const double u = std::sqrt(std::max(0.0, distance.u * distance.u - u_expansion * u_expansion));
      placement.certified(row, placement.unknowns + first_error + errors.of_distances[d]) = -weights.distances[d] * u;
    }
    if (has_common_error) {
      placement.certified.row(row) /= left_of_a_distance;
    }
  }
}

// "bar: ball A, radius".
std::string name_of(const ArtefactParameter& shared, const Constraints& constraints) {
  const Artefact& artefact = constraints.artefacts[shared.artefact];
  return fmt::format("{}: {}, quantity {}, {} mm, u {} mm", artefact.name, artefact.features[shared.feature].name,
                     static_cast<int>(shared.quantity), shared.certified, shared.u);
}

Eigen::MatrixXd known_before(const Weights& weights, int certificate_errors, int arm_size) {
  const auto shared = static_cast<Eigen::Index>(weights.shared.size());
  Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(shared + certificate_errors + arm_size, 1.0 / known_beforehand);
  for (Eigen::Index s = 0; s < shared; ++s) {
    diagonal[s] = std::max(diagonal[s], weights.shared[s]);
  }
  diagonal.segment(shared, certificate_errors).setOnes();
  return diagonal.asDiagonal();
}

}  // namespace

Expected<DesignPool> design_pool(const Recording& possible, const Constraints& constraints, const Arm& arm,
                                 const std::vector<Parameter>& free, const Noise& noise) {
  DesignPool pool;
  pool.system = make_system(possible, constraints, arm, free);
  const CertificateErrors errors = certificate_errors(constraints);
  pool.shared = pool.system.shared_size() + errors.size();
  for (const ArtefactParameter& shared : constraints.shared) {
    pool.shared_names.push_back(name_of(shared, constraints));
  }
  pool.shared_names.insert(pool.shared_names.end(), errors.names.begin(), errors.names.end());
  const auto unknowns = estimate_nuisance_parameters(pool.system, arm, possible);
  if (!unknowns) {
    return tl::unexpected(unknowns.error());
  }
  const Weights weights = first_weights(pool.system, arm, *unknowns, noise);
  const auto kinematics_by_probe = forward_kinematics_of(pool.system, arm);
  Places places = places_of(constraints);
  for (int f = 0; f < static_cast<int>(constraints.features.size()); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    add_readings(pool.system, weights.features[f], kinematics_by_probe, *unknowns, f,
                 feature.group ? places.of_group[*feature.group] : 0, pool.shared,
                 places.placements[places.index.at(feature.placement)]);
  }
  add_distances(possible, constraints, weights, *unknowns, errors, pool.system.shared_size(), places, pool.common());
  pool.placements = std::move(places.placements);
  pool.known = known_before(weights, errors.size(), pool.system.arm_size());
  return pool;
}

Eigen::MatrixXd information_of(const PossiblePlacement& placement, const std::vector<int>& chosen, int common) {
  TriangularFactor factor(placement.unknowns + common);
  if (placement.certified.rows() > 0) {
    factor.add(placement.certified);
  }
  for (const int k : chosen) {
    factor.add(placement.readings[static_cast<std::size_t>(k)].rows);
  }
  TriangularFactor told(common);
  told.add(eliminate_leading(factor.triangle(), placement.unknowns));
  return told.triangle();
}

Eigen::MatrixXd together(const Eigen::MatrixXd& triangle, const Eigen::MatrixXd& more) {
  TriangularFactor factor(static_cast<int>(triangle.cols()));
  factor.add(triangle);
  factor.add(more);
  return factor.triangle();
}

}  // namespace artcal
