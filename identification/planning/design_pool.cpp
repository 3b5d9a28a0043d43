#include "identification/planning/design_pool.h"

#include <map>

#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/rows.h"
#include "identification/least_squares/triangular_factor.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

constexpr double known_beforehand = 10.0;  // in the solver's units; see DesignPool::known

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
    if (feature.group >= 0 && places.of_group[feature.group] < 0) {
      int& unknowns = places.placements[entry->second].unknowns;
      places.of_group[feature.group] = unknowns;
      unknowns += constraints.groups[feature.group].size;
    }
  }
  return places;
}

// The rows of every reading of one feature.
void add_readings(const System& system, const FeatureWeights& weights,
                  const std::vector<ForwardKinematics>& kinematics_by_probe, const Unknowns& unknowns, int index,
                  int first_column, PossiblePlacement& placement) {
  const FeatureConstraint& feature = system.constraints->features[index];
  const GroupState none;
  const GroupState& group = feature.group < 0 ? none : unknowns.groups[feature.group];
  const FeatureResidual residual(feature, group.reference, group.values.data(), unknowns.shared.data());
  const int columns = placement.unknowns + system.shared_size() + system.arm_size();
  for (int k = 0; k < feature.size(); ++k) {
    RowMatrix rows = RowMatrix::Zero(feature.dimension(), columns + 1);
    weighted_rows(system, feature, weights, kinematics_by_probe, residual, k, 1,
                  {rows.cols(), rows.data() + columns, rows.data() + placement.unknowns + system.shared_size(),
                   feature.group < 0 ? nullptr : rows.data() + first_column,
                   system.shared_size() > 0 ? rows.data() + placement.unknowns : nullptr});
    placement.readings.push_back({feature.readings[k], index, rows.leftCols(columns)});
  }
}

void add_distances(const Constraints& constraints, const Weights& weights, const Unknowns& unknowns, Places& places,
                   int common) {
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    const DistanceConstraint& distance = constraints.distances[d];
    const FeatureConstraint& first = constraints.features[distance.first];
    if (!distance.binds) {
      continue;
    }
    PossiblePlacement& placement = places.placements[places.index.at(first.placement)];
    Eigen::VectorXd slope(constraints.groups[first.group].size);
    weighted_distance(distance, constraints, weights.distances[d], unknowns.groups[first.group].values.data(),
                      slope.data());
    const Eigen::Index row = placement.certified.rows();
    placement.certified.conservativeResize(row + 1, placement.unknowns + common);
    placement.certified.row(row).setZero();
    placement.certified.row(row).segment(places.of_group[first.group], slope.size()) = slope.transpose();
  }
}

Eigen::MatrixXd known_before(const Weights& weights, int arm_size) {
  const auto shared = static_cast<Eigen::Index>(weights.shared.size());
  Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(shared + arm_size, 1.0 / known_beforehand);
  for (Eigen::Index s = 0; s < shared; ++s) {
    diagonal[s] = std::max(diagonal[s], weights.shared[s]);
  }
  return diagonal.asDiagonal();
}

}  // namespace

Expected<DesignPool> design_pool(const Recording& possible, const Constraints& constraints, const Arm& arm,
                                 const std::vector<Parameter>& free, const Noise& noise) {
  DesignPool pool;
  pool.system = make_system(possible, constraints, arm, free);
  pool.shared = pool.system.shared_size();
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
                 feature.group < 0 ? 0 : places.of_group[feature.group],
                 places.placements[places.index.at(feature.placement)]);
  }
  add_distances(constraints, weights, *unknowns, places, pool.common());
  pool.placements = std::move(places.placements);
  pool.known = known_before(weights, pool.system.arm_size());
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
