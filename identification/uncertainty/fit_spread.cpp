#include "identification/uncertainty/fit_spread.h"

#include "core/triangular_solve.h"

#include <map>

namespace artcal {
namespace {

// Columns of `rows`, which are at the positions `from`, in the order of the positions `to`; zero where one is missing.
Eigen::MatrixXd reordered(const Eigen::MatrixXd& rows, const std::vector<Eigen::Index>& from,
                          const std::vector<Eigen::Index>& to) {
  std::map<Eigen::Index, Eigen::Index> at;
  for (std::size_t i = 0; i < from.size(); ++i) {
    at[from[i]] = static_cast<Eigen::Index>(i);
  }
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(rows.rows(), static_cast<Eigen::Index>(to.size()));
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (const auto found = at.find(to[i]); found != at.end()) {
      out.col(static_cast<Eigen::Index>(i)) = rows.col(found->second);
    }
  }
  return out;
}

Eigen::MatrixXd beside(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) {
  Eigen::MatrixXd both(left.rows(), left.cols() + right.cols());
  both << left, right;
  return both;
}

Eigen::MatrixXd of_columns(const Eigen::MatrixXd& root, const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  const Eigen::MatrixXd seen = root * columns;
  return seen.transpose() * seen;
}

}  // namespace

FitSpread::FitSpread(const ArrowFactor& factor, const Linearisation& squared, int arm_size)
    : factor_(factor), arm_size_(arm_size), parts_(factor.eliminated().size()) {
  const auto& fitted = factor.eliminated();
  std::vector<EliminatedRows> of_squared;
  const Eigen::MatrixXd arm = eliminate_nuisance(squared, arm_size, &of_squared);
  by_arm_ = arm.transpose() * arm;
  std::vector<int> interface(fitted.size(), -1);  // of each part: that of its component
  std::map<Eigen::Index, int> part_of;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    for (const Eigen::Index column : fitted[i].columns) {
      part_of[column] = static_cast<int>(i);
    }
  }
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    if (!fitted[i].rest.empty()) {
      interface[i] = part_of.at(fitted[i].rest.front());
      interface[static_cast<std::size_t>(interface[i])] = interface[i];
    }
  }
  std::map<int, int> component_of;  // by the index of its interface, or of its only part
  const std::vector<Eigen::Index> none;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const int top = interface[i] < 0 ? static_cast<int>(i) : interface[i];
    const auto& shared = interface[i] < 0 ? none : fitted[static_cast<std::size_t>(top)].columns;
    const bool is_leaf = top != static_cast<int>(i);
    Part& part = parts_[i];
    const auto [entry, is_new] = component_of.try_emplace(top, static_cast<int>(components_.size()));
    part.component = entry->second;
    const Eigen::Index width = static_cast<Eigen::Index>(shared.size()) + arm_size;
    if (is_new) {
      components_.push_back({Eigen::MatrixXd::Zero(width, width), {}});
    }
    const Eigen::MatrixXd own = reordered(of_squared[i].own, of_squared[i].columns, fitted[i].columns);
    if (is_leaf || shared.empty()) {
      const Eigen::MatrixXd others =
          beside(reordered(of_squared[i].by_rest, of_squared[i].rest, shared), of_squared[i].by_trailing);
      Eigen::MatrixXd follow = beside(reordered(fitted[i].by_rest, fitted[i].rest, shared), fitted[i].by_trailing);
      solve_upper(fitted[i].own, follow);
      part.rows = beside(own, others);
      part.following_rows = others - own * follow;
    } else {
      part.rows = beside(own, of_squared[i].by_trailing);
      part.following_rows = part.rows;  // of the interface itself: it follows nothing but the arm
    }
    components_[part.component].by_interface += part.following_rows.transpose() * part.following_rows;
  }
  for (const auto& [top, index] : component_of) {
    Gathered& component = components_[index];
    if (interface[static_cast<std::size_t>(top)] < 0) {
      component.by_arm = component.by_interface;
    } else {
      const EliminatedRows& rows = fitted[static_cast<std::size_t>(top)];
      Eigen::MatrixXd follow(rows.own.cols() + arm_size, arm_size);
      follow << -rows.own.triangularView<Eigen::Upper>().solve(rows.by_trailing),
          Eigen::MatrixXd::Identity(arm_size, arm_size);
      component.by_arm = follow.transpose() * component.by_interface * follow;
    }
    by_arm_ += component.by_arm;
  }
}

Eigen::MatrixXd FitSpread::of(const Block& block, const Eigen::Ref<const Eigen::MatrixXd>& solved) const {
  const auto arm = solved.bottomRows(arm_size_);
  const auto reached = factor_.reached_by(block);
  if (reached.empty()) {
    return arm.transpose() * by_arm_ * arm;
  }
  const Part& first = parts_[static_cast<std::size_t>(reached.front())];
  const Gathered& component = components_[static_cast<std::size_t>(first.component)];
  const auto common = solved.bottomRows(component.by_interface.rows());
  Eigen::MatrixXd sum = arm.transpose() * (by_arm_ - component.by_arm) * arm;
  sum += common.transpose() * component.by_interface * common;
  const bool is_leaf = solved.rows() > common.rows();
  if (is_leaf) {  // its own unknowns are moved, they do not only follow
    sum += of_columns(first.rows, solved) - of_columns(first.following_rows, common);
  }
  return sum;
}

}  // namespace artcal
