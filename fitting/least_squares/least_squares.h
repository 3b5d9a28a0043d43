#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "fitting/fit.h"
#include "fitting/least_squares/row_reducer.h"
#include "fitting/small_matrix.h"

namespace artcal::fitting {

template <typename State, int Size>
struct Solution {
  State state;
  Eigen::Matrix<double, Size, Size> triangle;  ///< R of the Jacobian at the state: RᵀR = JᵀWJ
  double cost = 0.0;                           ///< Σ w·d²
  FitStatus status = FitStatus::StepLimit;
  int steps = 0;
};

/// The Jacobian's triangle, the residuals in its space, and the cost, at one state.
template <int Size>
struct Linearised {
  Eigen::Matrix<double, Size, Size> triangle;
  Eigen::Matrix<double, Size, 1> rhs;
  double cost = 0.0;
};

template <typename Model>
Linearised<Model::size> linearise(const Model& model, const typename Model::State& state) {
  constexpr int n = Model::size;
  RowReducer<n + 1> reducer;
  double cost = 0.0;
  model.rows(state, [&](const Eigen::Matrix<double, 1, n + 1>& row) {
    cost += row(n) * row(n);
    reducer.add(row);
  });
  const auto triangle = reducer.triangle();
  return {triangle.template topLeftCorner<n, n>(), triangle.template topRightCorner<n, 1>(), cost};
}

/// min ‖R·x + rhs‖² + damping·‖D·x‖², by QR of the stacked matrix: no product RᵀR is formed. A direction
/// that the points do not see at all is left where it is.
template <int Size>
Eigen::Matrix<double, Size, 1> damped_step(const Linearised<Size>& at, const Eigen::Matrix<double, Size, 1>& column,
                                           double damping) {
  Eigen::Matrix<double, 2 * Size, Size> stacked;
  stacked << at.triangle, Eigen::Matrix<double, Size, Size>((std::sqrt(damping) * column).asDiagonal());
  Eigen::Matrix<double, 2 * Size, 1> rhs;
  rhs << -at.rhs, Eigen::Matrix<double, Size, 1>::Zero();
  return least_squares_solution(stacked, rhs);
}

/// One step, and whether it is so short that Gauss-Newton may be trusted without asking the cost: close to
/// the bottom the cost is flat to rounding and says no more about a step.
template <typename Model>
struct Move {
  Eigen::Matrix<double, Model::size, 1> step;
  double length;
  bool converged;
};

template <typename Model>
Move<Model> next_move(const Model& model, const typename Model::State& state, const Linearised<Model::size>& at,
                      const Eigen::Matrix<double, Model::size, 1>& column, double damping, bool may_trust) {
  constexpr double trustworthy = 1e-5;  // in units of the cloud's size
  Move<Model> move{damped_step<Model::size>(at, column, damping), 0.0, false};
  move.length = model.length_of(state, move.step);
  if (may_trust && move.length < trustworthy) {
    const auto full = damped_step<Model::size>(at, column, 0.0);
    const double length = model.length_of(state, full);
    if (length < trustworthy) {
      return {full, length, true};
    }
  }
  return move;
}

/// Levenberg-Marquardt with Moré's scaling, ending in plain Gauss-Newton. A Model has `size`, a `State`,
/// `rows(state, add)` that hands over [∂r/∂step | r] row by row, `moved(state, step)` and
/// `length_of(state, step)`.
///
/// Ends when the steps, which shrink by a steady factor near the solution, have less than rounding left
/// to go, or stop shrinking because rounding is all they are. Where they do not shrink for long (a point at a cone's
/// apex, whose distance has a kink there), only steps that lower the cost are taken from then on, until none does.
template <typename Model>
Solution<typename Model::State, Model::size> minimise(const Model& model, typename Model::State state, int max_steps) {
  constexpr double enough = 1e-15;   // of the remaining way, in units of the cloud's size
  constexpr double rounding = 1e-9;  // settled steps below this that no longer shrink are noise
  auto at = linearise(model, state);
  Eigen::Matrix<double, Model::size, 1> column = Eigen::Matrix<double, Model::size, 1>::Zero();
  Solution<typename Model::State, Model::size> solution{state, at.triangle, at.cost};
  double damping = 1e-4;
  std::optional<double> last;  // the step before, once settled
  constexpr int max_trusted = 150;
  int trusted = 0;  // settled steps
  while (solution.status != FitStatus::Converged && solution.steps < max_steps) {
    ++solution.steps;
    column = column.cwiseMax(at.triangle.colwise().norm().transpose());
    const auto move = next_move(model, state, at, column, damping, trusted < max_trusted);
    const double ratio = last ? std::min(move.length / *last, 1.0) : 0.9;
    const bool arrived = move.length * ratio < enough * std::max(1.0 - ratio, 0.1);
    const bool noise = move.length < rounding && ratio > 0.98;
    const bool growing = ratio == 1.0 && !noise;
    const auto next_state = model.moved(state, move.step);
    const auto next = linearise(model, next_state);
    if (move.converged && (arrived || noise)) {
      solution.status = FitStatus::Converged;
    }
    trusted += move.converged ? 1 : 0;
    const bool no_worse = next.cost < at.cost || (next.cost == at.cost && trusted < max_trusted);
    if (no_worse || (move.converged && !growing && std::isfinite(next.cost))) {
      state = next_state;
      at = next;
      damping *= 0.1;
      last = move.converged ? std::optional(move.length) : std::nullopt;
      continue;
    }
    damping = std::max(damping * 8.0, 1e-6);
    if (damping > 1e12) {  // no step is short enough to be better: the bottom, as far as doubles can see
      solution.status = FitStatus::Converged;
    }
  }
  solution.state = state;
  solution.triangle = at.triangle;
  solution.cost = at.cost;
  return solution;
}

}  // namespace artcal::fitting
