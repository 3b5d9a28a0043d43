#include "identification/monte_carlo/arrow_factor.h"

#include "core/triangular_solve.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace artcal {
namespace {

// Below this, relative to the largest element of the diagonal, a triangle is singular to working precision.
constexpr double singular = 1e-14;

bool is_regular(const Eigen::MatrixXd& triangle) {
  if (triangle.size() == 0) {
    return true;
  }
  const auto diagonal = triangle.diagonal().cwiseAbs();
  return diagonal.minCoeff() > singular * diagonal.maxCoeff();
}

}  // namespace

Expected<ArrowFactor> ArrowFactor::of(const Linearisation& linearisation, Folding folding) {
  ArrowFactor factor;
  factor.layout_ = linearisation.layout;
  const Eigen::Index arm_size = factor.layout_.size - factor.layout_.arm;
  factor.arm_ = eliminate_nuisance(linearisation, static_cast<int>(arm_size), &factor.eliminated_, folding);
  for (const EliminatedRows& rows : factor.eliminated_) {
    if (rows.own.rows() < rows.own.cols()) {
      return no_solution("the readings of one placement do not determine where the artefact stood");
    }
  }
  if (!is_regular(factor.arm_)) {
    return no_solution("the readings do not determine the parameters at the identified arm");
  }
  factor.index_rows();
  return factor;
}

void ArrowFactor::index_rows() {
  rows_of_.assign(static_cast<std::size_t>(layout_.arm), -1);
  place_.assign(static_cast<std::size_t>(layout_.arm), 0);
  for (std::size_t i = 0; i < eliminated_.size(); ++i) {
    const auto& columns = eliminated_[i].columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      rows_of_[columns[k]] = static_cast<int>(i);
      place_[columns[k]] = static_cast<Eigen::Index>(k);
    }
  }
  for (std::size_t i = 0; i < eliminated_.size(); ++i) {
    const auto& columns = eliminated_[i].columns;
    if (std::any_of(columns.begin(), columns.end(), [&](Eigen::Index at) { return at >= layout_.common; })) {
      for_common_.push_back(static_cast<int>(i));
      if (!eliminated_[i].rest.empty()) {
        for_common_.push_back(rows_of_[eliminated_[i].rest.front()]);
      }
    }
  }
  std::sort(for_common_.begin(), for_common_.end());
  for_common_.erase(std::unique(for_common_.begin(), for_common_.end()), for_common_.end());
}

ArrowFactor::Step ArrowFactor::solve(const Eigen::VectorXd& gradient) const {
  std::vector<const EliminatedRows*> rows;
  for (const EliminatedRows& each : eliminated_) {
    rows.push_back(&each);
  }
  return solve_arrow(layout_, rows, arm_, gradient);
}

// Forwards Rᵀy = gradient, |y| being the length asked for, and backwards Rδ = y.
ArrowFactor::Step solve_arrow(const StateLayout& layout, const std::vector<const EliminatedRows*>& rows,
                              const Eigen::MatrixXd& arm_triangle, const Eigen::VectorXd& gradient) {
  ArrowFactor::Step step{gradient, 0.0};
  Eigen::VectorXd& y = step.numbers;
  auto arm = y.tail(layout.size - layout.arm);
  for (const EliminatedRows* each : rows) {
    Eigen::VectorXd own = y(each->columns);
    solve_upper_transposed(each->own, own);
    y(each->columns) = own;
    y(each->rest) -= each->by_rest.transpose() * own;
    arm.noalias() -= each->by_trailing.transpose() * own;
  }
  solve_upper_transposed(arm_triangle, arm);
  step.length = y.norm();
  solve_upper(arm_triangle, arm);
  for (auto each = rows.rbegin(); each != rows.rend(); ++each) {
    const EliminatedRows& part = **each;
    Eigen::VectorXd own = y(part.columns) - part.by_rest * y(part.rest) - part.by_trailing * arm;
    solve_upper(part.own, own);
    y(part.columns) = own;
  }
  return step;
}

// As solve_arrow(), without the rows where y is zero and those that nothing asked for follows from.
Eigen::VectorXd ArrowFactor::solve_for_common(int group, const Eigen::VectorXd& gradient_of_group) const {
  std::map<int, Eigen::VectorXd> y;  // of eliminated rows; zero in all others
  const auto of_rows = [&](int rows) -> Eigen::VectorXd& {
    return y.try_emplace(rows, Eigen::VectorXd::Zero(eliminated_[rows].own.cols())).first->second;
  };
  const Eigen::Index first = layout_.groups[group];
  for (Eigen::Index i = 0; i < gradient_of_group.size(); ++i) {
    of_rows(rows_of_[first + i])[place_[first + i]] = gradient_of_group[i];
  }
  Eigen::VectorXd common = Eigen::VectorXd::Zero(layout_.size - layout_.common);
  auto arm = common.tail(layout_.size - layout_.arm);
  for (auto entry = y.begin(); entry != y.end(); ++entry) {  // an interface that joins them stands behind its leaves
    const EliminatedRows& part = eliminated_[entry->first];
    Eigen::VectorXd& own = entry->second;
    solve_upper_transposed(part.own, own);
    const Eigen::VectorXd of_rest = part.by_rest.transpose() * own;
    for (std::size_t i = 0; i < part.rest.size(); ++i) {
      of_rows(rows_of_[part.rest[i]])[place_[part.rest[i]]] -= of_rest[static_cast<Eigen::Index>(i)];
    }
    arm.noalias() -= part.by_trailing.transpose() * own;
  }
  solve_upper_transposed(arm_, arm);
  solve_upper(arm_, arm);
  for (auto rows = for_common_.rbegin(); rows != for_common_.rend(); ++rows) {
    const EliminatedRows& part = eliminated_[*rows];
    Eigen::VectorXd of_rest(static_cast<Eigen::Index>(part.rest.size()));
    for (std::size_t i = 0; i < part.rest.size(); ++i) {
      of_rest[static_cast<Eigen::Index>(i)] = of_rows(rows_of_[part.rest[i]])[place_[part.rest[i]]];
    }
    Eigen::VectorXd own = of_rows(*rows) - part.by_rest * of_rest - part.by_trailing * arm;
    solve_upper(part.own, own);
    for (std::size_t i = 0; i < part.columns.size(); ++i) {
      if (part.columns[i] >= layout_.common) {
        common[part.columns[i] - layout_.common] = own[static_cast<Eigen::Index>(i)];
      }
    }
    of_rows(*rows) = std::move(own);
  }
  return common;
}

// With independent w of unit variance for each row of R, δ = R⁻¹w has the covariance (RᵀR)⁻¹. Backwards, the δ of each
// eliminated set is a combination of its own w and of those of what remained; that of an interface (no rest) is kept
// for the leaves before it.
Eigen::VectorXd ArrowFactor::parameter_variances() const {
  const Eigen::Index arm_size = layout_.size - layout_.arm;
  Eigen::MatrixXd of_arm = Eigen::MatrixXd::Identity(arm_size, arm_size);
  solve_upper(arm_, of_arm);
  Eigen::VectorXd variances = Eigen::VectorXd::Zero(layout_.arm - layout_.common);
  std::vector<Eigen::Index> row_of(static_cast<std::size_t>(layout_.size));
  Eigen::MatrixXd interface;  // by the w of the interface, then of the arm
  for (auto rows = eliminated_.rbegin(); rows != eliminated_.rend(); ++rows) {
    const Eigen::Index size = rows->own.cols();
    const Eigen::Index of_interface = rows->rest.empty() ? 0 : interface.rows();
    Eigen::MatrixXd combination = Eigen::MatrixXd::Zero(size, size + of_interface + arm_size);
    combination.leftCols(size).setIdentity();
    combination.rightCols(arm_size).noalias() -= rows->by_trailing * of_arm;
    for (std::size_t i = 0; i < rows->rest.size(); ++i) {
      combination.rightCols(of_interface + arm_size).noalias() -=
          rows->by_rest.col(static_cast<Eigen::Index>(i)) * interface.row(row_of[rows->rest[i]]);
    }
    solve_upper(rows->own, combination);
    for (Eigen::Index i = 0; i < size; ++i) {
      row_of[rows->columns[i]] = i;
      if (const Eigen::Index s = rows->columns[i] - layout_.common; s >= 0) {
        variances[s] = combination.row(i).squaredNorm();
      }
    }
    if (rows->rest.empty()) {
      interface = std::move(combination);
    }
  }
  return variances;
}

// Where a block's unknowns stand in the state vector.
std::vector<Eigen::Index> ArrowFactor::positions_of(const Block& block) const {
  std::vector<Eigen::Index> positions;
  for (Eigen::Index i = 0; i < block.unknowns; ++i) {
    positions.push_back(layout_.groups[block.group] + i);
  }
  for (Eigen::Index i = 0; i < block.parameters.size; ++i) {
    positions.push_back(layout_.common + block.parameters.first + i);
  }
  for (Eigen::Index i = layout_.arm; i < layout_.size; ++i) {
    positions.push_back(i);
  }
  return positions;
}

std::vector<int> ArrowFactor::reached_by(const Block& block) const {
  std::vector<int> reached;
  for (const Eigen::Index position : positions_of(block)) {
    if (position < layout_.arm) {
      const int rows = rows_of_[position];
      reached.push_back(rows);
      if (const auto& rest = eliminated_[rows].rest; !rest.empty()) {
        reached.push_back(rows_of_[rest.front()]);
      }
    }
  }
  std::sort(reached.begin(), reached.end());
  reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
  return reached;
}

Eigen::MatrixXd ArrowFactor::half_solved(const Block& block, const Eigen::Ref<const Eigen::MatrixXd>& rows) const {
  const auto reached = reached_by(block);
  const auto positions = positions_of(block);
  const Eigen::Index arm_size = layout_.size - layout_.arm;
  std::map<Eigen::Index, Eigen::Index> at;  // of a position, in the result
  Eigen::Index size = 0;
  for (const int i : reached) {
    for (const Eigen::Index column : eliminated_[i].columns) {
      at[column] = size++;
    }
  }
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(size + arm_size, rows.rows());
  for (Eigen::Index i = 0; i < rows.cols(); ++i) {
    y.row(positions[i] < layout_.arm ? at.at(positions[i]) : size + positions[i] - layout_.arm) =
        rows.col(i).transpose();
  }
  auto arm = y.bottomRows(arm_size);
  Eigen::Index first = 0;
  for (const int index : reached) {
    const EliminatedRows& part = eliminated_[index];
    auto own = y.middleRows(first, part.own.cols());
    solve_upper_transposed(part.own, own);
    for (std::size_t i = 0; i < part.rest.size(); ++i) {
      y.row(at.at(part.rest[i])) -= part.by_rest.col(static_cast<Eigen::Index>(i)).transpose() * own;
    }
    arm.noalias() -= part.by_trailing.transpose() * own;
    first += part.own.cols();
  }
  solve_upper_transposed(arm_, arm);
  return y;
}

Eigen::MatrixXd ArrowFactor::fully_solved(const Block& block, const Eigen::MatrixXd& half) const {
  const auto reached = reached_by(block);
  const Eigen::Index arm_size = layout_.size - layout_.arm;
  Eigen::MatrixXd x = half;
  auto arm = x.bottomRows(arm_size);
  solve_upper(arm_, arm);
  std::map<Eigen::Index, Eigen::Index> at;
  Eigen::Index end = x.rows() - arm_size;
  for (auto index = reached.rbegin(); index != reached.rend(); ++index) {
    const EliminatedRows& rows = eliminated_[*index];
    auto own = x.middleRows(end - rows.own.cols(), rows.own.cols());
    own.noalias() -= rows.by_trailing * arm;
    for (std::size_t i = 0; i < rows.rest.size(); ++i) {
      own.noalias() -= rows.by_rest.col(static_cast<Eigen::Index>(i)) * x.row(at.at(rows.rest[i]));
    }
    solve_upper(rows.own, own);
    end -= rows.own.cols();
    for (std::size_t i = 0; i < rows.columns.size(); ++i) {
      at[rows.columns[i]] = end + static_cast<Eigen::Index>(i);
    }
  }
  return x;
}

Eigen::MatrixXd ArrowFactor::solved(const Block& block, const Eigen::MatrixXd& half) const {
  const Eigen::MatrixXd x = fully_solved(block, half);
  std::map<Eigen::Index, Eigen::Index> at;
  for (const int index : reached_by(block)) {
    for (const Eigen::Index column : eliminated_[index].columns) {
      const auto next = static_cast<Eigen::Index>(at.size());
      at[column] = next;
    }
  }
  const auto positions = positions_of(block);
  Eigen::MatrixXd of_block(static_cast<Eigen::Index>(positions.size()), x.cols());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    of_block.row(static_cast<Eigen::Index>(i)) =
        x.row(positions[i] < layout_.arm ? at.at(positions[i]) : x.rows() - layout_.size + positions[i]);
  }
  return of_block;
}

}  // namespace artcal
