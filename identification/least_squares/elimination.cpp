#include "identification/least_squares/elimination.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include <Eigen/QR>

#include "identification/least_squares/row_stack.h"

namespace artcal {
namespace {

constexpr double independent = 1e-12;  // of a column's part beside the others

int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    i = parent[i] = parent[parent[i]];
  }
  return i;
}

/// Adjacent positions of the state vector.
struct Run {
  Eigen::Index at = 0;
  Eigen::Index size = 0;
};

std::vector<Eigen::Index> positions_in_runs(const std::vector<Run>& runs) {
  std::vector<Eigen::Index> positions;
  for (const Run& run : runs) {
    for (Eigen::Index i = 0; i < run.size; ++i) {
      positions.push_back(run.at + i);
    }
  }
  return positions;
}

Eigen::Index size_of(const std::vector<Run>& runs) {
  return std::accumulate(runs.begin(), runs.end(), Eigen::Index{0},
                         [](Eigen::Index sum, const Run& run) { return sum + run.size; });
}

/// Rows [leaf | interface run | trailing] of one block; either of the first two may be missing.
struct Part {
  int interface = -1;  // into the component's interface, or -1
  const BlockRows* block = nullptr;
};

class Elimination {
 public:
  Elimination(const Linearisation& linearisation, int trailing, std::vector<EliminatedRows>* eliminated,
              Folding folding)
      : linearisation_(linearisation),
        trailing_(trailing),
        eliminated_(eliminated),
        root_(trailing, folding, trailing + 1) {}  // however few rows come, it is a triangle

  Eigen::MatrixXd triangle() {
    index_blocks();
    for (const BlockRows& block : linearisation_.blocks) {
      if (block.nuisance() == 0) {
        root_.add(block.rows.leftCols(trailing_));
      }
    }
    for (const Component& component : components_of(linearisation_.blocks)) {
      take_out(component);
    }
    return root_.rows();
  }

 private:
  [[nodiscard]] Run run_of_group(int group, int size) const { return {linearisation_.layout.groups[group], size}; }
  [[nodiscard]] Run run_of(const FeatureParameters& parameters) const {
    return {linearisation_.layout.common + parameters.first, parameters.size};
  }

  void index_blocks() {
    for (const BlockRows& block : linearisation_.blocks) {
      if (block.group >= 0) {
        by_group_[block.group].push_back(&block);
        size_of_group_[block.group] = block.unknowns;
      }
      if (block.parameters.size > 0) {
        by_parameters_[block.parameters.first].push_back(&block);
      }
    }
  }

  void take_out(const Component& component) {
    std::vector<Run> leaves;
    std::vector<Run> interface;
    std::vector<std::vector<Part>> parts;  // of each leaf
    std::map<int, int> interface_index;
    const bool by_groups = component.groups_are_leaves;
    for (const int group : component.groups) {
      if (!by_groups) {
        interface_index[group] = static_cast<int>(interface.size());
      }
      (by_groups ? leaves : interface).push_back(run_of_group(group, size_of_group_.at(group)));
    }
    for (const FeatureParameters& parameters : component.parameters) {
      if (by_groups) {
        interface_index[parameters.first] = static_cast<int>(interface.size());
      }
      (by_groups ? interface : leaves).push_back(run_of(parameters));
    }
    const auto interface_of = [&](const BlockRows& block) {
      const bool there = by_groups ? block.parameters.size > 0 : block.group >= 0;
      return there ? interface_index.at(by_groups ? block.parameters.first : block.group) : -1;
    };
    std::vector<RowStack> beside;  // rows of each interface run without a leaf
    for (const Run& run : interface) {
      beside.emplace_back(static_cast<int>(run.size) + trailing_);
    }
    RowStack common(static_cast<int>(size_of(interface)) + trailing_);
    RowStack& left_of_leaves = interface.empty() ? root_ : common;
    std::vector<Eigen::Index> starts{0};
    for (const Run& run : interface) {
      starts.push_back(starts.back() + run.size);
    }
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const auto& blocks =
          by_groups ? by_group_.at(component.groups[i]) : by_parameters_.at(component.parameters[i].first);
      std::vector<Part> of_leaf;
      for (const BlockRows* block : blocks) {
        of_leaf.push_back({interface_of(*block), block});
      }
      take_out_leaf(leaves[i], by_groups, of_leaf, interface, starts, beside, left_of_leaves);
    }
    // Rows without a leaf: certificates where groups are the leaves, a group's other readings where parameters are.
    const auto add_beside = [&](const BlockRows* block, int at) {
      beside[at].add(block->rows.leftCols(block->nuisance() + trailing_));
    };
    for (std::size_t i = 0; i < interface.size(); ++i) {
      const auto& blocks =
          by_groups ? by_parameters_.at(component.parameters[i].first) : by_group_.at(component.groups[i]);
      for (const BlockRows* block : blocks) {
        if (by_groups ? block->group < 0 : block->parameters.size == 0) {
          add_beside(block, static_cast<int>(i));
        }
      }
      common.add(scattered(beside[i].rows(), interface[i].size, {{0, starts[i]}}, {interface[i].size}, starts.back()));
    }
    if (!interface.empty()) {
      root_.add(eliminate(common.rows(), interface, {}));
    }
  }

  // Puts runs of leading columns elsewhere: `to` holds (first column here, first column there) of runs of these sizes.
  [[nodiscard]] Eigen::MatrixXd scattered(const Eigen::MatrixXd& rows, Eigen::Index leading,
                                          const std::vector<std::pair<Eigen::Index, Eigen::Index>>& to,
                                          const std::vector<Eigen::Index>& sizes, Eigen::Index width) const {
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(rows.rows(), width + trailing_);
    for (std::size_t i = 0; i < to.size(); ++i) {
      out.middleCols(to[i].second, sizes[i]) = rows.middleCols(to[i].first, sizes[i]);
    }
    out.rightCols(trailing_) = rows.middleCols(leading, trailing_);
    return out;
  }

  void take_out_leaf(const Run& leaf, bool by_groups, const std::vector<Part>& parts, const std::vector<Run>& interface,
                     const std::vector<Eigen::Index>& starts, std::vector<RowStack>& beside, RowStack& left_of_leaves) {
    std::vector<int> seen;
    for (const Part& part : parts) {
      if (part.interface >= 0 && std::find(seen.begin(), seen.end(), part.interface) == seen.end()) {
        seen.push_back(part.interface);
      }
    }
    std::sort(seen.begin(), seen.end());
    std::vector<Run> rest;
    std::vector<Eigen::Index> rest_starts{leaf.size};
    for (const int i : seen) {
      rest.push_back(interface[i]);
      rest_starts.push_back(rest_starts.back() + interface[i].size);
    }
    const Eigen::Index width = rest_starts.back();
    RowStack front(static_cast<int>(width) + trailing_);
    for (const Part& part : parts) {
      const Eigen::MatrixXd rows = leaf_first(*part.block, by_groups);
      if (part.interface < 0) {
        front.add(scattered(rows, leaf.size, {{0, 0}}, {leaf.size}, width));
        continue;
      }
      // Only as many rows as the leaf has columns need involve it: the others are the interface run's own.
      const Eigen::Index size = interface[part.interface].size;
      const Eigen::Index place = rest_starts[std::lower_bound(seen.begin(), seen.end(), part.interface) - seen.begin()];
      const Eigen::Index involved = std::min(rows.rows(), leaf.size);
      const Eigen::MatrixXd reduced = with_leading_zeros(rows, leaf.size);
      front.add(scattered(reduced.topRows(involved), leaf.size + size, {{0, 0}, {leaf.size, place}}, {leaf.size, size},
                          width));
      if (rows.rows() > involved) {
        beside[part.interface].add(reduced.bottomRightCorner(rows.rows() - involved, size + trailing_));
      }
    }
    const Eigen::MatrixXd left = eliminate(front.rows(), {leaf}, rest);
    std::vector<std::pair<Eigen::Index, Eigen::Index>> to;
    std::vector<Eigen::Index> sizes;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      to.emplace_back(rest_starts[i] - leaf.size, starts[seen[i]]);
      sizes.push_back(rest[i].size);
    }
    left_of_leaves.add(scattered(left, width - leaf.size, to, sizes, starts.back()));
  }

  // The rows of a block as [leaf | the other | trailing].
  [[nodiscard]] Eigen::MatrixXd leaf_first(const BlockRows& block, bool group_is_leaf) const {
    Eigen::MatrixXd rows = block.rows.leftCols(block.nuisance() + trailing_);
    if (!group_is_leaf) {
      rows.leftCols(block.parameters.size) = block.rows.middleCols(block.unknowns, block.parameters.size);
      rows.middleCols(block.parameters.size, block.unknowns) = block.rows.leftCols(block.unknowns);
    }
    return rows;
  }

  // Reflects rows so that below the first `leading` rows the first `leading` columns are zero.
  static Eigen::MatrixXd with_leading_zeros(const Eigen::MatrixXd& rows, Eigen::Index leading) {
    if (rows.rows() <= leading) {
      return rows;
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows.leftCols(leading));
    Eigen::MatrixXd reduced = rows;
    reduced.leftCols(leading).setZero();
    reduced.topLeftCorner(leading, leading) = qr.matrixQR().topRows(leading).triangularView<Eigen::Upper>();
    reduced.rightCols(rows.cols() - leading).applyOnTheLeft(qr.householderQ().transpose());
    return reduced;
  }

  // How many rows there are until all that follow are zero in the leading columns; of a triangle as many as columns.
  static Eigen::Index rows_involving(const Eigen::MatrixXd& rows, Eigen::Index leading) {
    Eigen::Index count = rows.rows();
    while (count > 0 && (rows.row(count - 1).head(leading).array() == 0.0).all()) {
      --count;
    }
    return count;
  }

  // Takes the unknowns of `own` out of rows [own | rest | trailing]; returns what is left of [rest | trailing].
  Eigen::MatrixXd eliminate(const Eigen::MatrixXd& rows, const std::vector<Run>& own, const std::vector<Run>& rest) {
    const Eigen::Index size = size_of(own);
    const Eigen::Index involved = rows_involving(rows, size);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows.topLeftCorner(involved, size));
    qr.setThreshold(independent);
    const Eigen::Index rank = qr.rank();
    Eigen::MatrixXd others = rows.rightCols(rows.cols() - size);
    others.topRows(involved).applyOnTheLeft(qr.householderQ().transpose());
    if (eliminated_ != nullptr) {
      EliminatedRows& out = eliminated_->emplace_back();
      const auto positions = positions_in_runs(own);
      for (Eigen::Index i = 0; i < size; ++i) {
        out.columns.push_back(positions[qr.colsPermutation().indices()[i]]);
      }
      out.rest = positions_in_runs(rest);
      out.own = qr.matrixQR().topRows(rank).triangularView<Eigen::Upper>();
      out.by_rest = others.topLeftCorner(rank, others.cols() - trailing_);
      out.by_trailing = others.topRightCorner(rank, trailing_);
    }
    return others.bottomRows(others.rows() - rank);
  }

  const Linearisation& linearisation_;
  int trailing_;
  std::vector<EliminatedRows>* eliminated_;
  RowStack root_;
  std::map<int, std::vector<const BlockRows*>> by_group_;
  std::map<int, int> size_of_group_;
  std::map<int, std::vector<const BlockRows*>> by_parameters_;
};

}  // namespace

std::vector<Component> components_of(const std::vector<BlockRows>& blocks) {
  int groups = 0;
  int parameters = 0;
  for (const BlockRows& block : blocks) {
    groups = std::max(groups, block.group + 1);
    parameters = std::max(parameters, block.parameters.first + block.parameters.size);
  }
  // Groups, then first entries of feature parameters.
  std::vector<int> parent(static_cast<std::size_t>(groups + parameters));
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<int> size(parent.size(), 0);
  for (const BlockRows& block : blocks) {
    if (block.group >= 0) {
      size[block.group] = block.unknowns;
    }
    if (block.parameters.size > 0) {
      size[groups + block.parameters.first] = block.parameters.size;
    }
    if (block.group >= 0 && block.parameters.size > 0) {
      parent[root_of(parent, groups + block.parameters.first)] = root_of(parent, block.group);
    }
  }
  std::vector<Component> components;
  std::map<int, std::size_t> index;
  for (int i = 0; i < groups + parameters; ++i) {
    if (size[i] == 0) {
      continue;
    }
    const auto [entry, is_new] = index.try_emplace(root_of(parent, i), components.size());
    if (is_new) {
      components.emplace_back();
    }
    Component& component = components[entry->second];
    if (i < groups) {
      component.groups.push_back(i);
    } else {
      component.parameters.push_back({i - groups, size[i]});
    }
  }
  for (Component& component : components) {
    int of_groups = 0;
    int of_parameters = 0;
    for (const int group : component.groups) {
      of_groups += size[group];
    }
    for (const FeatureParameters& each : component.parameters) {
      of_parameters += each.size;
    }
    component.groups_are_leaves = of_parameters < of_groups;
  }
  return components;
}

Eigen::MatrixXd eliminate_nuisance(const Linearisation& linearisation, int trailing,
                                   std::vector<EliminatedRows>* eliminated, Folding folding) {
  return Elimination(linearisation, trailing, eliminated, folding).triangle();
}

}  // namespace artcal
