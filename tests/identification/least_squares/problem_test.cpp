#include "identification/least_squares/problem.h"

#include <array>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "identification/initial/nuisance_estimation.h"
#include "identification/problem/weights.h"
#include "tests/support/probing/session.h"

namespace artcal {
namespace {

std::vector<Parameter> named(const Arm& arm, const std::vector<std::string>& names) {
  std::vector<Parameter> chosen;
  for (const auto& name : names) {
    const auto all = parameters_of(arm);
    chosen.push_back(all[static_cast<std::size_t>(find_parameter(all, name))]);
  }
  return chosen;
}

Solution solved(const probing::Bound& bound, const std::vector<std::string>& names) {
  const Arm& arm = bound.recording.arm;
  const System system = make_system(bound.recording, bound.constraints, arm, named(arm, names));
  auto unknowns = estimate_nuisance_parameters(system, arm, bound.recording);
  if (!unknowns) throw std::runtime_error(unknowns.error().text());
  return solve(system, unit_weights(bound.constraints), Eigen::VectorXd::Zero(system.arm_size()), std::move(*unknowns));
}

// A column that is there twice makes the normal equations singular: the solver's linear steps fail until it damps them.
// Such a failed step moves nothing, and that is no sign of convergence.
TEST(Solve, AFailedLinearStepIsNotConvergence) {
  for (const probing::Kind kind : {probing::Kind::Seats, probing::Kind::Bar3}) {
    const auto bound = probing::bound(probing::probe({.kind = kind, .placements = 4, .rough = 0.3}), 0.0);
    const Solution once = solved(bound, {"theta2", "a3", "l"});
    const Solution twice = solved(bound, {"theta2", "a3", "l", "l"});
    ASSERT_EQ(once.termination, Termination::Converged) << once.message;
    EXPECT_LT(once.final_cost, 0.9 * once.initial_cost);
    if (twice.termination == Termination::Converged) {
      EXPECT_NEAR(twice.final_cost, once.final_cost, 1e-6 * once.final_cost) << twice.message;
      EXPECT_NEAR(twice.x[2] + twice.x[3], once.x[2], 1e-4) << "both columns together do what the one did";
    }
  }
}

// A prior about a place that the readings do not determine is where the solution is; its weight counts in the triangle.
TEST(Solve, APriorDecidesWhatReadingsDoNot) {
  const auto bound = probing::bound(probing::probe({.kind = probing::Kind::Seats, .placements = 4, .rough = 0.3}), 0.0);
  const Arm& arm = bound.recording.arm;
  const System system = make_system(bound.recording, bound.constraints, arm, named(arm, {"theta2", "d1"}));
  auto unknowns = estimate_nuisance_parameters(system, arm, bound.recording);
  ASSERT_TRUE(unknowns);
  SolveOptions options;
  options.prior_weights = Eigen::Vector2d(0.0, 0.5);
  options.prior_at = Eigen::Vector2d(0.0, 7.0);
  const Solution solution =
      solve(system, unit_weights(bound.constraints), Eigen::VectorXd::Zero(2), std::move(*unknowns), options);
  ASSERT_EQ(solution.termination, Termination::Converged) << solution.message;
  EXPECT_NEAR(solution.x[1], 7.0, 1e-6);  // d1 moves the base frame, which the seats do not see
  const Eigen::MatrixXd triangle = arm_triangle(solution.linearisation, 2);
  EXPECT_NEAR((triangle.transpose() * triangle).inverse()(1, 1), 1.0 / (0.5 * 0.5), 1e-6);
}

// Not to linearise at the solution is only less work: the solution has the same bits, after as many steps.
TEST(Solve, WithoutTheSolutionsLinearisationEndsAtTheSameBits) {
  for (const probing::Kind kind : {probing::Kind::Seats, probing::Kind::Bar3}) {
    const auto bound = probing::bound(probing::probe({.kind = kind, .placements = 4, .rough = 0.3}), 0.0);
    const Arm& arm = bound.recording.arm;
    const System system = make_system(bound.recording, bound.constraints, arm, named(arm, {"theta2", "a3", "l"}));
    const auto unknowns = estimate_nuisance_parameters(system, arm, bound.recording);
    ASSERT_TRUE(unknowns);
    SolveOptions options;
    options.folding = Folding::NormalEquations;
    for (const double still : {1e-2, 1e-6}) {
      options.still = still;
      std::array<Solution, 2> found;
      for (const bool linearise : {false, true}) {
        options.linearise_solution = linearise;
        found[linearise] = solve(system, unit_weights(bound.constraints), Eigen::VectorXd::Zero(3), *unknowns, options);
        ASSERT_EQ(found[linearise].termination, Termination::Converged);
      }
      EXPECT_EQ(found[0].x, found[1].x);
      EXPECT_EQ(found[0].iterations, found[1].iterations);
      EXPECT_EQ(found[0].message, found[1].message);
      for (std::size_t g = 0; g < unknowns->groups.size(); ++g) {
        EXPECT_EQ(found[0].unknowns.groups[g].values, found[1].unknowns.groups[g].values);
      }
      EXPECT_GT(found[0].iterations, 1);
    }
  }
}

}  // namespace
}  // namespace artcal
