#include "identification/linearised.h"

#include <algorithm>
#include <vector>

#include "identification/rows.h"
#include "identification/triangular_factor.h"

namespace artcal {
namespace {

constexpr int readings_at_once = 32;

/// Buffers that every run of readings uses again.
struct Scratch {
  std::vector<double> by_arm, by_group;
  RowMatrix both;
};

void add_feature(const System& system, const FeatureConstraint& feature, const FeatureWeights& weights,
                 const std::vector<Sweep>& sweeps, const GroupState& group, Scratch& scratch,
                 TriangularFactor& factor) {
  const int arm_size = system.arm_size();
  const int group_size = static_cast<int>(group.values.size());
  for (int first = 0; first < feature.size(); first += readings_at_once) {
    const int count = std::min(readings_at_once, feature.size() - first);
    const int rows = count * feature.dimension();
    scratch.by_arm.resize(static_cast<std::size_t>(rows * arm_size));
    scratch.by_group.resize(static_cast<std::size_t>(rows * group_size));
    weighted_rows(system, feature, weights, sweeps, group.reference, group.values.data(), first, count,
                  {nullptr, scratch.by_arm.data(), group_size > 0 ? scratch.by_group.data() : nullptr});
    if (group_size == 0) {
      factor.add(scratch.by_arm.data(), rows);
      continue;
    }
    scratch.both.resize(rows, group_size + arm_size);
    scratch.both.leftCols(group_size) = Eigen::Map<RowMatrix>(scratch.by_group.data(), rows, group_size);
    scratch.both.rightCols(arm_size) = Eigen::Map<RowMatrix>(scratch.by_arm.data(), rows, arm_size);
    factor.add(scratch.both.data(), rows);
  }
}

}  // namespace

Eigen::MatrixXd arm_triangle(const System& system, const Weights& weights, const Arm& arm, const Unknowns& unknowns) {
  const Constraints& constraints = *system.constraints;
  const auto sweeps = sweeps_of(system, arm);
  TriangularFactor arm_factor(system.arm_size());
  Scratch scratch;
  std::vector<std::vector<std::size_t>> features_of(constraints.groups.size());
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const auto& feature = constraints.features[f];
    if (feature.group < 0) {
      add_feature(system, feature, weights.features[f], sweeps, {}, scratch, arm_factor);
    } else {
      features_of[feature.group].push_back(f);
    }
  }
  std::vector<std::vector<std::size_t>> distances_of(constraints.groups.size());
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    if (constraints.distances[d].binds) {
      distances_of[constraints.features[constraints.distances[d].first].group].push_back(d);
    }
  }
  for (std::size_t g = 0; g < constraints.groups.size(); ++g) {
    const int group_size = constraints.groups[g].size;
    TriangularFactor factor(group_size + system.arm_size());
    for (const std::size_t f : features_of[g]) {
      add_feature(system, constraints.features[f], weights.features[f], sweeps, unknowns[g], scratch, factor);
    }
    for (const std::size_t d : distances_of[g]) {
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(group_size + system.arm_size());
      weighted_distance(constraints.distances[d], constraints, weights.distances[d], unknowns[g].values.data(),
                        row.data());
      factor.add(row.data(), 1);
    }
    arm_factor.add(eliminate_leading(factor.triangle(), group_size));
  }
  return arm_factor.triangle();
}

}  // namespace artcal
