#pragma once

#include <Eigen/Core>

namespace artcal {

/// Solves R x = b in place, R the upper triangle of `triangle` (n, n) and b of shape (n, any). Nothing is done where
/// either is empty: Eigen 3.4 would take a reference to an element that is not there.
template <typename Triangle, typename RightSide>
void solve_upper(const Triangle& triangle, RightSide&& right_side) {
  if (triangle.size() > 0 && right_side.size() > 0) {
    triangle.template triangularView<Eigen::Upper>().solveInPlace(right_side);
  }
}

/// The same for Rᵀ x = b.
template <typename Triangle, typename RightSide>
void solve_upper_transposed(const Triangle& triangle, RightSide&& right_side) {
  if (triangle.size() > 0 && right_side.size() > 0) {
    triangle.transpose().template triangularView<Eigen::Lower>().solveInPlace(right_side);
  }
}

}  // namespace artcal
