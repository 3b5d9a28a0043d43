#include "identification/least_squares/blocks.h"

#include <map>

#include "identification/problem/system.h"

namespace artcal {
namespace {

// Of each entry of Constraints::shared: all entries of the same feature of the same artefact, which are adjacent.
std::vector<FeatureParameters> feature_parameters(const Constraints& constraints) {
  const auto& shared = constraints.shared;
  std::vector<FeatureParameters> all(shared.size());
  for (std::size_t first = 0; first < shared.size();) {
    std::size_t end = first + 1;
    while (end < shared.size() && shared[end].artefact == shared[first].artefact &&
           shared[end].feature == shared[first].feature) {
      ++end;
    }
    for (std::size_t s = first; s < end; ++s) {
      all[s] = {static_cast<int>(first), static_cast<int>(end - first)};
    }
    first = end;
  }
  return all;
}

}  // namespace

std::vector<Block> blocks_of(const Constraints& constraints) {
  const auto parameters = feature_parameters(constraints);
  std::vector<std::vector<Block>> of_group(constraints.groups.size() + 1);
  for (std::size_t g = 0; g < of_group.size(); ++g) {
    const int group = static_cast<int>(g) - 1;
    of_group[g].push_back({group, group < 0 ? 0 : constraints.groups[group].size, {}});
  }
  std::map<std::pair<int, int>, std::size_t> index;  // group, first parameter
  for (int f = 0; f < static_cast<int>(constraints.features.size()); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    const int group = feature.group.value_or(-1);
    auto& blocks = of_group[group + 1];
    const auto entry = feature.first_error ? feature.first_error : feature.shared_radius();
    if (!entry) {
      blocks.front().features.push_back(f);
      continue;
    }
    const auto [place, is_new] = index.try_emplace({group, parameters[*entry].first}, blocks.size());
    if (is_new) {
      blocks.push_back({group, blocks.front().unknowns, parameters[*entry]});
    }
    blocks[place->second].features.push_back(f);
  }
  for (int d = 0; d < static_cast<int>(constraints.distances.size()); ++d) {
    const DistanceConstraint& distance = constraints.distances[d];
    if (distance.binds) {
      of_group[*constraints.features[distance.first].group + 1].front().distances.push_back(d);
    }
  }
  std::vector<Block> all;
  for (std::size_t g = 0; g < of_group.size(); ++g) {
    for (Block& block : of_group[g]) {
      if (g == 0 || block.parameters.size > 0 || !block.features.empty() || !block.distances.empty()) {
        all.push_back(std::move(block));
      }
    }
  }
  for (std::size_t s = 0; s < parameters.size(); s += parameters[s].size) {
    all.push_back({-1, 0, parameters[s], true});
  }
  return all;
}

StateLayout layout_of(const Constraints& constraints, int arm_size) {
  StateLayout layout;
  for (const UnknownGroup& group : constraints.groups) {
    layout.groups.push_back(layout.common);
    layout.common += group.size;
  }
  layout.arm = layout.common + static_cast<Eigen::Index>(constraints.shared.size());
  layout.size = layout.arm + arm_size;
  return layout;
}

Eigen::VectorXd packed(const StateLayout& layout, const Unknowns& unknowns, const Eigen::VectorXd& x) {
  Eigen::VectorXd numbers(layout.size);
  for (std::size_t g = 0; g < unknowns.groups.size(); ++g) {
    const Eigen::VectorXd& values = unknowns.groups[g].values;
    numbers.segment(layout.groups[g], values.size()) = values;
  }
  numbers.segment(layout.common, unknowns.shared.size()) = unknowns.shared;
  numbers.tail(x.size()) = x;
  return numbers;
}

void unpack(const StateLayout& layout, const Eigen::VectorXd& numbers, Unknowns& unknowns) {
  for (std::size_t g = 0; g < unknowns.groups.size(); ++g) {
    Eigen::VectorXd& values = unknowns.groups[g].values;
    values = numbers.segment(layout.groups[g], values.size());
  }
  unknowns.shared = numbers.segment(layout.common, unknowns.shared.size());
}

}  // namespace artcal
