#include "identification/initial/faint_turns.h"

#include <algorithm>
#include <optional>

#include "identification/initial/nuisance_estimation.h"
#include "identification/initial/pose_start.h"

namespace artcal {
namespace {

constexpr int max_corrections = 10;
// A relative decrease of the cost that is more than rounding.
constexpr double lower = 1e-9;

bool is_faint(const UnknownGroup& group) { return group.line && group.turn == PoseTurn::Free; }

bool has_faint_turns(const Constraints& constraints) {
  return std::any_of(constraints.groups.begin(), constraints.groups.end(), is_faint);
}

// Takes over the poses of `estimated` that fit better. True if there was one.
bool correct_turns(const System& system, const Weights& weights, Loss loss, const Arm& arm, const Unknowns& estimated,
                   Unknowns& unknowns) {
  const Constraints& constraints = *system.constraints;
  const auto kinematics_by_probe = forward_kinematics_of(system, arm);
  const auto blocks = blocks_of(constraints);
  bool any = false;
  for (std::size_t g = 0; g < constraints.groups.size(); ++g) {
    if (!is_faint(constraints.groups[g])) {
      continue;
    }
    const auto cost = [&](const GroupState& group) {
      double sum = 0.0;
      for (const Block& block : blocks) {
        if (block.group == static_cast<int>(g)) {
          sum += block_cost(system, weights, loss, block, kinematics_by_probe,
                            {group.reference, group.values.data(), unknowns.shared.data()});
        }
      }
      return sum;
    };
    if (cost(estimated.groups[g]) < (1.0 - lower) * cost(unknowns.groups[g])) {
      unknowns.groups[g] = estimated.groups[g];
      any = true;
    }
  }
  return any;
}

Solution solve_and_correct(const System& system, const Recording& recording, const Weights& weights, Solution solution,
                           const SolveOptions& options) {
  for (int i = 0; i < max_corrections && solution.termination == Termination::Converged; ++i) {
    const Arm arm = system.arm_at(solution.x.data());
    const auto estimated = estimate_nuisance_parameters(system, arm, recording);
    Unknowns corrected = solution.unknowns;
    if (!estimated || !correct_turns(system, weights, options.loss, arm, *estimated, corrected)) {
      break;
    }
    Solution next = solve(system, weights, solution.x, std::move(corrected), options);
    if (next.termination != Termination::Converged || !(next.final_cost < (1.0 - lower) * solution.final_cost)) {
      break;
    }
    next.iterations += solution.iterations;
    solution = std::move(next);
  }
  return solution;
}

// Arm and unknowns from a solution with scaled turns.
std::optional<Solution> start_from_scaled(const System& system, const Recording& recording, const Weights& weights,
                                          const Eigen::VectorXd& x_start, const SolveOptions& options) {
  const Constraints scaled_constraints = with_scaled_turns(*system.constraints);
  System scaled = system;
  scaled.constraints = &scaled_constraints;
  auto unknowns = estimate_nuisance_parameters(scaled, system.arm_at(x_start.data()), recording);
  if (!unknowns) {
    return std::nullopt;
  }
  Solution solution = solve(scaled, weights, x_start, std::move(*unknowns), options);
  if (solution.termination == Termination::Failed) {
    return std::nullopt;
  }
  for (std::size_t g = 0; g < solution.unknowns.groups.size(); ++g) {
    if (is_faint(system.constraints->groups[g])) {
      solution.unknowns.groups[g] = with_free_turn(solution.unknowns.groups[g]);
    }
  }
  return solution;
}

}  // namespace

SolveOptions patient_options(const Constraints& constraints, const SolveOptions& options) {
  SolveOptions patient = options;
  patient.max_iterations *= has_faint_turns(constraints) ? 20 : 1;
  return patient;
}

Solution with_corrected_turns(Solution solution, const System& system, const Recording& recording,
                              const Weights& weights, const Eigen::VectorXd& x_start, const SolveOptions& options) {
  if (!has_faint_turns(*system.constraints)) {
    return solution;
  }
  const SolveOptions patient = patient_options(*system.constraints, options);
  solution = solve_and_correct(system, recording, weights, std::move(solution), patient);
  if (auto scaled = start_from_scaled(system, recording, weights, x_start, options)) {
    Solution other = solve(system, weights, scaled->x, std::move(scaled->unknowns), patient);
    other.iterations += scaled->iterations;
    other = solve_and_correct(system, recording, weights, std::move(other), patient);
    if (other.termination == Termination::Converged &&
        (solution.termination != Termination::Converged || other.final_cost < solution.final_cost)) {
      return other;
    }
  }
  return solution;
}

}  // namespace artcal
