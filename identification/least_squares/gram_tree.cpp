#include "identification/least_squares/gram_tree.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "identification/monte_carlo/gradient.h"

namespace artcal {
namespace {

Placement placement_of(const FeatureConstraint& feature) { return {feature.artefact, feature.placement}; }

}  // namespace

std::vector<Block> placed_blocks(const Constraints& constraints, std::vector<std::optional<Placement>>& places) {
  std::vector<Block> all;
  places.clear();
  for (Block& block : blocks_of(constraints)) {
    if (block.features.empty()) {
      all.push_back(std::move(block));
      places.emplace_back();
      continue;
    }
    std::map<Placement, std::vector<int>> features;
    for (const int f : block.features) {
      features[placement_of(constraints.features[f])].push_back(f);
    }
    for (auto& [place, own] : features) {
      Block& part = all.emplace_back(block);
      part.features = std::move(own);
      places.emplace_back(place);
      block.distances.clear();  // with the first; a group is of one placement
    }
  }
  return all;
}

GramTree::GramTree(const PlacedLinearisation& placed) : placed_(placed) {
  const Linearisation& linearisation = placed.linearisation;
  const StateLayout& layout = linearisation.layout;
  arm_size_ = layout.size - layout.arm;
  by_group_.resize(layout.groups.size());
  by_parameters_.resize(static_cast<std::size_t>(layout.arm - layout.common));
  gram_ = Eigen::MatrixXd::Zero(arm_size_, arm_size_);
  for (std::size_t b = 0; b < linearisation.blocks.size(); ++b) {
    const BlockRows& block = linearisation.blocks[b];
    if (block.group >= 0) {
      by_group_[block.group].push_back(b);
    }
    if (block.parameters.size > 0) {
      by_parameters_[block.parameters.first].push_back(b);
    }
    if (block.nuisance() == 0) {
      gram_ += gram_of(b);
    }
  }
  components_ = components_of(linearisation.blocks);
  component_of_group_.assign(layout.groups.size(), -1);
  for (std::size_t c = 0; c < components_.size(); ++c) {
    for (const int group : components_[c].groups) {
      component_of_group_[group] = static_cast<int>(c);
    }
    branches_.push_back(branch(components_[c], nullptr));
    gram_ += branches_.back().to_arm;
    regular_ = regular_ && branches_.back().regular;
  }
}

// Of the block's nuisance unknowns and the arm, not of the residual.
Eigen::MatrixXd GramTree::gram_of(std::size_t block) const {
  const Eigen::MatrixXd& rows = placed_.linearisation.blocks[block].rows;
  const auto j = rows.leftCols(rows.cols() - 1);
  return j.transpose() * j;
}

std::vector<Eigen::Index> GramTree::group_positions(int group) const {
  std::vector<Eigen::Index> positions;
  const int size = placed_.linearisation.blocks[by_group_[group].front()].unknowns;
  for (int i = 0; i < size; ++i) {
    positions.push_back(placed_.linearisation.layout.groups[group] + i);
  }
  return positions;
}

std::vector<Eigen::Index> GramTree::positions_of(const FeatureParameters& parameters) const {
  std::vector<Eigen::Index> positions;
  for (int i = 0; i < parameters.size; ++i) {
    positions.push_back(placed_.linearisation.layout.common + parameters.first + i);
  }
  return positions;
}

// Adds (sign 1) or takes away (−1) what the blocks of a leaf say of [interface | arm], the leaf eliminated. False where
// they do not determine it.
bool GramTree::add_leaf(const std::vector<Eigen::Index>& own, const std::vector<std::size_t>& blocks,
                        const Placement* without, double sign, Branch& branch) const {
  const auto size = static_cast<Eigen::Index>(own.size());
  const auto interface_size = static_cast<Eigen::Index>(branch.interface.size());
  const Eigen::Index width = size + interface_size + arm_size_;
  const auto at = [&](Eigen::Index position) {
    if (const auto place = std::lower_bound(own.begin(), own.end(), position);
        place != own.end() && *place == position) {
      return static_cast<Eigen::Index>(place - own.begin());
    }
    return size +
           (std::lower_bound(branch.interface.begin(), branch.interface.end(), position) - branch.interface.begin());
  };
  Eigen::MatrixXd by = Eigen::MatrixXd::Zero(size, width);
  for (const std::size_t b : blocks) {
    if (without != nullptr && is_of(b, *without)) {
      continue;
    }
    const BlockRows& block = placed_.linearisation.blocks[b];
    std::vector<Eigen::Index> columns;
    for (int i = 0; i < block.unknowns; ++i) {
      columns.push_back(at(placed_.linearisation.layout.groups[block.group] + i));
    }
    for (int i = 0; i < block.parameters.size; ++i) {
      columns.push_back(at(placed_.linearisation.layout.common + block.parameters.first + i));
    }
    for (Eigen::Index i = 0; i < arm_size_; ++i) {
      columns.push_back(size + interface_size + i);
    }
    const Eigen::MatrixXd gram = gram_of(b);
    for (Eigen::Index j = 0; j < gram.cols(); ++j) {
      for (Eigen::Index i = 0; i < gram.rows(); ++i) {
        if (columns[i] < size) {
          by(columns[i], columns[j]) += gram(i, j);
        } else if (columns[j] >= size) {
          branch.gram(columns[i] - size, columns[j] - size) += sign * gram(i, j);
        }
      }
    }
  }
  if (size == 0) {
    return true;
  }
  const Eigen::LLT<Eigen::MatrixXd> cholesky(by.leftCols(size));
  if (cholesky.info() != Eigen::Success) {
    return false;
  }
  const Eigen::MatrixXd rest = cholesky.matrixL().solve(by.rightCols(width - size));
  branch.gram.noalias() -= sign * (rest.transpose() * rest);
  if (sign > 0.0) {
    EliminatedRows& rows = branch.leaves.emplace_back();
    rows.columns = own;
    rows.rest = branch.interface;
    rows.own = cholesky.matrixU();
    rows.by_rest = rest.leftCols(interface_size);
    rows.by_trailing = rest.rightCols(arm_size_);
  }
  return true;
}

void GramTree::eliminate_interface(Branch& branch) const {
  const auto size = static_cast<Eigen::Index>(branch.interface.size());
  if (size == 0) {
    branch.to_arm = branch.gram;
    return;
  }
  const Eigen::LLT<Eigen::MatrixXd> cholesky(branch.gram.topLeftCorner(size, size));
  if (cholesky.info() != Eigen::Success) {
    branch.regular = false;
    return;
  }
  const Eigen::MatrixXd rest = cholesky.matrixL().solve(branch.gram.topRightCorner(size, arm_size_));
  branch.to_arm = branch.gram.bottomRightCorner(arm_size_, arm_size_) - rest.transpose() * rest;
  branch.interface_rows.push_back({branch.interface, {}, cholesky.matrixU(), Eigen::MatrixXd(size, 0), rest});
}

GramTree::Branch GramTree::branch(const Component& component, const Placement* without) const {
  Branch branch;
  std::vector<std::pair<std::vector<Eigen::Index>, const std::vector<std::size_t>*>> leaves;
  std::vector<const std::vector<std::size_t>*> beside;  // blocks of each interface unknown
  const auto is_gone = [&](int group) {
    return without != nullptr && std::all_of(by_group_[group].begin(), by_group_[group].end(),
                                             [&](std::size_t b) { return is_of(b, *without); });
  };
  const auto put = [&](const std::vector<Eigen::Index>& positions, const std::vector<std::size_t>& blocks, bool leaf) {
    if (leaf) {
      leaves.emplace_back(positions, &blocks);
    } else {
      branch.interface.insert(branch.interface.end(), positions.begin(), positions.end());
      beside.push_back(&blocks);
    }
  };
  for (const int group : component.groups) {
    if (!is_gone(group)) {
      put(group_positions(group), by_group_[group], component.groups_are_leaves);
    }
  }
  for (const FeatureParameters& parameters : component.parameters) {
    put(positions_of(parameters), by_parameters_[parameters.first], !component.groups_are_leaves);
  }
  const auto width = static_cast<Eigen::Index>(branch.interface.size()) + arm_size_;
  branch.gram = Eigen::MatrixXd::Zero(width, width);
  for (const auto& [positions, blocks] : leaves) {
    branch.regular = branch.regular && add_leaf(positions, *blocks, without, 1.0, branch);
  }
  for (const auto* blocks : beside) {
    std::vector<std::size_t> alone;
    for (const std::size_t b : *blocks) {
      const BlockRows& block = placed_.linearisation.blocks[b];
      if (component.groups_are_leaves ? block.group < 0 : block.parameters.size == 0) {
        alone.push_back(b);
      }
    }
    branch.regular = branch.regular && add_leaf({}, alone, without, 1.0, branch);
  }
  if (branch.regular) {
    eliminate_interface(branch);
  }
  return branch;
}

// Where placements are the leaves: the component with the contribution of one of them taken away.
GramTree::Branch GramTree::without_leaf(std::size_t component, const Placement& placement) const {
  Branch changed;
  changed.interface = branches_[component].interface;
  changed.gram = branches_[component].gram;
  for (const int group : components_[component].groups) {
    if (is_of(by_group_[group].front(), placement)) {
      changed.regular = changed.regular && add_leaf(group_positions(group), by_group_[group], nullptr, -1.0, changed);
    }
  }
  // Readings of features without a group of their own.
  for (const FeatureParameters& parameters : components_[component].parameters) {
    for (const std::size_t b : by_parameters_[parameters.first]) {
      if (placed_.linearisation.blocks[b].group < 0 && is_of(b, placement)) {
        changed.regular = changed.regular && add_leaf({}, {b}, nullptr, -1.0, changed);
      }
    }
  }
  if (changed.regular) {
    eliminate_interface(changed);
  }
  return changed;
}

std::optional<GramTree::Without> GramTree::without(const Placement& placement) const {
  if (!regular_) {
    return std::nullopt;
  }
  Without rest;
  rest.layout_ = &placed_.linearisation.layout;
  rest.gram_ = gram_;
  std::vector<bool> affected(components_.size(), false);
  for (std::size_t b = 0; b < placed_.places.size(); ++b) {
    if (!is_of(b, placement)) {
      continue;
    }
    const BlockRows& block = placed_.linearisation.blocks[b];
    if (block.nuisance() == 0) {
      rest.gram_ -= gram_of(b);
    } else if (block.group >= 0) {
      affected[component_of_group_[block.group]] = true;
    } else {
      for (std::size_t c = 0; c < components_.size(); ++c) {
        const auto& all = components_[c].parameters;
        affected[c] = affected[c] || std::any_of(all.begin(), all.end(), [&](const FeatureParameters& parameters) {
                        return parameters.first == block.parameters.first;
                      });
      }
    }
  }
  rest.own_.reserve(components_.size());
  for (std::size_t c = 0; c < components_.size(); ++c) {
    const Branch& whole = branches_[c];
    if (!affected[c]) {
      for (const auto* rows : {&whole.leaves, &whole.interface_rows}) {
        for (const EliminatedRows& each : *rows) {
          rest.rows_.push_back(&each);
        }
      }
      continue;
    }
    const bool by_placement = components_[c].groups_are_leaves;
    Branch changed = by_placement ? without_leaf(c, placement) : branch(components_[c], &placement);
    if (!changed.regular) {
      return std::nullopt;
    }
    rest.gram_ += changed.to_arm - whole.to_arm;
    if (by_placement) {
      for (std::size_t i = 0; i < components_[c].groups.size(); ++i) {
        if (!is_of(by_group_[components_[c].groups[i]].front(), placement)) {
          rest.rows_.push_back(&whole.leaves[i]);
        }
      }
    }
    for (auto* rows : {&changed.leaves, &changed.interface_rows}) {
      rest.own_.push_back(std::move(*rows));
      for (const EliminatedRows& each : rest.own_.back()) {
        rest.rows_.push_back(&each);
      }
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> cholesky(rest.gram_);
  if (cholesky.info() != Eigen::Success) {
    return std::nullopt;
  }
  rest.triangle_ = cholesky.matrixU();
  return rest;
}

ArrowFactor::Step GramTree::Without::solve(const Eigen::VectorXd& gradient) const {
  return solve_arrow(*layout_, rows_, triangle_, gradient);
}

double GramTree::Without::condition() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram_, Eigen::EigenvaluesOnly);
  const double least = eigen.eigenvalues().minCoeff();
  return least > 0.0 ? std::sqrt(least / eigen.eigenvalues().maxCoeff()) : 0.0;
}

Eigen::MatrixXd GramTree::Without::arm_covariance() const {
  const Eigen::MatrixXd inverse = triangle_.triangularView<Eigen::Upper>().solve(
      Eigen::MatrixXd::Identity(triangle_.rows(), triangle_.cols()).eval());
  return inverse * inverse.transpose();
}

Eigen::VectorXd GramTree::gradient_of(const Placement& placement) const {
  Linearisation own;
  own.layout = placed_.linearisation.layout;
  for (std::size_t b = 0; b < placed_.places.size(); ++b) {
    if (is_of(b, placement)) {
      own.blocks.push_back(placed_.linearisation.blocks[b]);
    }
  }
  return gradient(own);
}

}  // namespace artcal
