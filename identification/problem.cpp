#include "identification/problem.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <ceres/ceres.h>

#include "identification/rows.h"

namespace artcal {
namespace {

// Long enough to pay for setting up the arm once a block, short enough for the cache.
constexpr int readings_a_block = 64;

// Tuning for 95 % efficiency on normal noise (Holland, Welsch 1977).
constexpr double huber_threshold = 1.345;
constexpr double cauchy_threshold = 2.385;

/// Readings [first, first + count) of one feature as a Ceres cost: parameter blocks are the arm's x and,
/// where the feature has unknowns, its group's values.
class FeatureCost final : public ceres::CostFunction {
 public:
  FeatureCost(const System& system, const FeatureConstraint& feature, const FeatureWeights& weights,
              const Eigen::Matrix3d& reference, int first, int count)
      : system_(system), feature_(feature), weights_(weights), reference_(reference), first_(first), count_(count) {
    set_num_residuals(count * feature.dimension());
    mutable_parameter_block_sizes()->push_back(system.arm_size());
    if (feature.group >= 0) {
      mutable_parameter_block_sizes()->push_back(system.constraints->groups[feature.group].size);
    }
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const auto sweeps = sweeps_of(system_, system_.arm_at(parameters[0]));
    const double* group = feature_.group < 0 ? nullptr : parameters[1];
    RowsOut out{residuals, nullptr, nullptr};
    if (jacobians != nullptr) {
      out.by_arm = jacobians[0];
      out.by_group = feature_.group < 0 ? nullptr : jacobians[1];
    }
    weighted_rows(system_, feature_, weights_, sweeps, reference_, group, first_, count_, out);
    return true;
  }

 private:
  const System& system_;
  const FeatureConstraint& feature_;
  const FeatureWeights& weights_;
  Eigen::Matrix3d reference_;
  int first_;
  int count_;
};

/// A certified distance between two unknown points of one group.
class DistanceCost final : public ceres::CostFunction {
 public:
  DistanceCost(const Constraints& constraints, const DistanceConstraint& distance, double weight)
      : constraints_(constraints), distance_(distance), weight_(weight) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(constraints.groups[constraints.features[distance.first].group].size);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    residuals[0] = weighted_distance(distance_, constraints_, weight_, parameters[0],
                                     jacobians == nullptr ? nullptr : jacobians[0]);
    return true;
  }

 private:
  const Constraints& constraints_;
  const DistanceConstraint& distance_;
  double weight_;
};

std::unique_ptr<ceres::LossFunction> make_loss(Loss loss, int dimension) {
  // A three-dimensional residual of normal noise is √3 as long.
  const double width = std::sqrt(static_cast<double>(dimension));
  switch (loss) {
    case Loss::Huber: return std::make_unique<ceres::HuberLoss>(huber_threshold * width);
    case Loss::Cauchy: return std::make_unique<ceres::CauchyLoss>(cauchy_threshold * width);
    case Loss::None: break;
  }
  return nullptr;
}

void add_feature(ceres::Problem& problem, const System& system, const FeatureConstraint& feature,
                 const FeatureWeights& weights, Loss loss, double* x, Unknowns& unknowns) {
  const int step = loss == Loss::None ? readings_a_block : 1;
  for (int first = 0; first < feature.size(); first += step) {
    const int count = std::min(step, feature.size() - first);
    const Eigen::Matrix3d reference =
        feature.group < 0 ? Eigen::Matrix3d::Identity() : unknowns[feature.group].reference;
    std::vector<double*> blocks{x};
    if (feature.group >= 0) {
      blocks.push_back(unknowns[feature.group].values.data());
    }
    problem.AddResidualBlock(new FeatureCost(system, feature, weights, reference, first, count),
                             make_loss(loss, feature.dimension()).release(), blocks);
  }
}

ceres::Solver::Options solver_options(const SolveOptions& options) {
  ceres::Solver::Options ceres_options;
  ceres_options.max_num_iterations = options.max_iterations;
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  // Gauss-Newton first; the region shrinks fast where that does not lower the cost.
  ceres_options.initial_trust_region_radius = 1e16;
  // Stop where a step moves nothing that matters (0.3 nm on an arm and its placements), or where the cost
  // has come down to its own rounding; the gradient's size has no unit to judge it by.
  ceres_options.parameter_tolerance = 1e-10;
  ceres_options.function_tolerance = 1e-14;
  ceres_options.gradient_tolerance = 0.0;
  return ceres_options;
}

Termination termination_of(const ceres::Solver::Summary& summary) {
  if (summary.termination_type == ceres::CONVERGENCE) {
    return Termination::Converged;
  }
  return summary.IsSolutionUsable() ? Termination::NoConvergence : Termination::Failed;
}

}  // namespace

Solution solve(const System& system, const Weights& weights, const Eigen::VectorXd& x_start, Unknowns start,
               const SolveOptions& options) {
  Solution solution;
  solution.x = x_start;
  solution.unknowns = std::move(start);
  const Constraints& constraints = *system.constraints;
  ceres::Problem problem;
  problem.AddParameterBlock(solution.x.data(), system.arm_size());
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    add_feature(problem, system, constraints.features[f], weights.features[f], options.loss, solution.x.data(),
                solution.unknowns);
  }
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    const DistanceConstraint& distance = constraints.distances[d];
    if (distance.binds) {
      problem.AddResidualBlock(new DistanceCost(constraints, distance, weights.distances[d]), nullptr,
                               solution.unknowns[constraints.features[distance.first].group].values.data());
    }
  }
  ceres::Solver::Options ceres_options = solver_options(options);
  if (constraints.groups.empty()) {
    ceres_options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  } else {
    ceres_options.linear_solver_type = ceres::DENSE_SCHUR;
    ceres_options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    ceres_options.linear_solver_ordering->AddElementToGroup(solution.x.data(), 1);
    for (auto& group : solution.unknowns) {
      ceres_options.linear_solver_ordering->AddElementToGroup(group.values.data(), 0);
    }
  }
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options, &problem, &summary);
  solution.termination = termination_of(summary);
  solution.iterations = static_cast<int>(summary.iterations.size()) - 1;
  solution.initial_cost = summary.initial_cost;
  solution.final_cost = summary.final_cost;
  solution.message = summary.message;
  return solution;
}

LossValue loss_at(Loss loss, double s) {
  const auto function = make_loss(loss, 1);
  if (function == nullptr) {
    return {s, 1.0};
  }
  double rho[3];
  function->Evaluate(s, rho);
  return {rho[0], rho[1]};
}

}  // namespace artcal
