#include "identification/arrow_factor.h"

#include <cmath>
#include <utility>

#include "identification/triangular_factor.h"

namespace artcal {
namespace {

bool is_regular(const Eigen::MatrixXd& triangle) {
  return triangle.size() == 0 || triangle.diagonal().cwiseAbs().minCoeff() > 0.0;
}

}  // namespace

NumberLayout layout_of(const System& system) {
  NumberLayout layout;
  for (const UnknownGroup& group : system.constraints->groups) {
    layout.groups.push_back(layout.common);
    layout.common += group.size;
  }
  layout.arm = layout.common + system.shared_size();
  layout.size = layout.arm + system.arm_size();
  return layout;
}

Expected<ArrowFactor> ArrowFactor::of(const Linearisation& linearisation, const NumberLayout& layout) {
  ArrowFactor factor;
  factor.layout_ = layout;
  const Eigen::Index common = layout.size - layout.common;
  TriangularFactor rest(static_cast<int>(common));
  for (const Eigen::MatrixXd& triangle : linearisation.triangles) {
    const Eigen::Index own = triangle.cols() - 1 - common;
    rest.add(triangle.block(own, own, common, common));
    if (&triangle != &linearisation.triangles.front()) {
      factor.groups_.push_back({triangle.topLeftCorner(own, own), triangle.block(0, own, own, common)});
      if (!is_regular(factor.groups_.back().own)) {
        return no_solution("the readings of one placement do not determine where the artefact stood");
      }
    }
  }
  factor.common_ = rest.triangle();
  if (!is_regular(factor.common_)) {
    return no_solution("the readings do not determine the parameters at the identified arm");
  }
  return factor;
}

// Forwards Rᵀy = gradient, |y| being the length asked for, and backwards Rδ = y.
ArrowFactor::Step ArrowFactor::solve(const Eigen::VectorXd& gradient) const {
  Step step{gradient, 0.0};
  Eigen::VectorXd& y = step.numbers;
  auto common = y.tail(layout_.size - layout_.common);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    auto own = y.segment(layout_.groups[g], group.own.rows());
    group.own.transpose().triangularView<Eigen::Lower>().solveInPlace(own);
    common.noalias() -= group.by_common.transpose() * own;
  }
  common_.transpose().triangularView<Eigen::Lower>().solveInPlace(common);
  step.length = y.norm();
  common_.triangularView<Eigen::Upper>().solveInPlace(common);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    auto own = y.segment(layout_.groups[g], group.own.rows());
    own.noalias() -= group.by_common * common;
    group.own.triangularView<Eigen::Upper>().solveInPlace(own);
  }
  return step;
}

Eigen::MatrixXd ArrowFactor::half_solved(std::size_t block, const Eigen::Ref<const Eigen::MatrixXd>& rows) const {
  Eigen::MatrixXd y = rows.transpose();
  auto common = y.bottomRows(common_.rows());
  if (block > 0) {
    const Group& group = groups_[block - 1];
    auto own = y.topRows(group.own.rows());
    group.own.transpose().triangularView<Eigen::Lower>().solveInPlace(own);
    common.noalias() -= group.by_common.transpose() * own;
  }
  common_.transpose().triangularView<Eigen::Lower>().solveInPlace(common);
  return y;
}

Eigen::MatrixXd ArrowFactor::solved(std::size_t block, const Eigen::MatrixXd& half) const {
  Eigen::MatrixXd x = half;
  auto common = x.bottomRows(common_.rows());
  common_.triangularView<Eigen::Upper>().solveInPlace(common);
  if (block > 0) {
    const Group& group = groups_[block - 1];
    auto own = x.topRows(group.own.rows());
    own.noalias() -= group.by_common * common;
    group.own.triangularView<Eigen::Upper>().solveInPlace(own);
  }
  return x;
}

Eigen::MatrixXd ArrowFactor::following(std::size_t block) const {
  if (block == 0) {
    return Eigen::MatrixXd(0, common_.cols());
  }
  return -groups_[block - 1].own.triangularView<Eigen::Upper>().solve(groups_[block - 1].by_common);
}

}  // namespace artcal
