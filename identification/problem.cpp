#include "identification/problem.h"

#include <cmath>
#include <memory>
#include <vector>

#include <ceres/ceres.h>
#include <fmt/format.h>

#include "identification/rows.h"
#include "identification/triangular_factor.h"

namespace artcal {
namespace {

/// One block of the linearisation as a Ceres cost. Parameter blocks: what all blocks have in common (the
/// shared unknowns, then the arm's x) and, where there are any, the group's unknowns. Residuals and Jacobian
/// are the triangle's last column and the others: cost, gradient and normal matrix are those of all the rows
/// behind them. Where only the cost is wanted, its root stands in the last residual.
class BlockCost final : public ceres::CostFunction {
 public:
  BlockCost(const System& system, const Weights& weights, Loss loss, Block block, GroupReference reference,
            const Eigen::MatrixXd* at_start, Eigen::MatrixXd& triangle)
      : system_(system),
        weights_(weights),
        loss_(loss),
        block_(std::move(block)),
        reference_(std::move(reference)),
        at_start_(at_start),
        triangle_(triangle) {
    const int common = system.shared_size() + system.arm_size();
    set_num_residuals(block_.unknowns + common + 1);
    mutable_parameter_block_sizes()->push_back(common);
    if (block_.unknowns > 0) {
      mutable_parameter_block_sizes()->push_back(block_.unknowns);
    }
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const BlockPoint point{reference_, block_.unknowns > 0 ? parameters[1] : nullptr, parameters[0]};
    const double* x = parameters[0] + system_.shared_size();
    Eigen::Map<Eigen::VectorXd> out(residuals, num_residuals());
    if (jacobians == nullptr) {
      const auto sweeps = sweeps_of(system_, system_.arm_at(x));
      out.setZero();
      out[out.size() - 1] = std::sqrt(block_cost(system_, weights_, loss_, block_, sweeps, point));
      return true;
    }
    if (at_start_ != nullptr) {
      triangle_ = *at_start_;  // Ceres evaluates first where it starts
      at_start_ = nullptr;
    } else {
      const auto sweeps = sweeps_of(system_, system_.arm_at(x));
      triangle_ = block_triangle(system_, weights_, loss_, block_, sweeps, point);
    }
    out = triangle_.rightCols<1>();
    const int common = parameter_block_sizes().front();
    if (jacobians[0] != nullptr) {
      Eigen::Map<RowMatrix>(jacobians[0], out.size(), common) = triangle_.middleCols(block_.unknowns, common);
    }
    if (block_.unknowns > 0 && jacobians[1] != nullptr) {
      Eigen::Map<RowMatrix>(jacobians[1], out.size(), block_.unknowns) = triangle_.leftCols(block_.unknowns);
    }
    return true;
  }

 private:
  const System& system_;
  const Weights& weights_;
  Loss loss_;
  Block block_;
  GroupReference reference_;
  mutable const Eigen::MatrixXd* at_start_;
  Eigen::MatrixXd& triangle_;  // the last one evaluated: at the end, the solution's
};

// Trust regions above this leave the Gauss-Newton step as it is.
constexpr double undamped = 1e8;
// Steps that may fail in a row before Ceres gives up: from the region we begin with down to one that damps any system.
constexpr int max_invalid_steps = 20;

/// Pseudo-observations of the arm's steps, each with its weight; the artefact parameters before them have none.
class PriorCost final : public ceres::CostFunction {
 public:
  PriorCost(const SolveOptions& options, int shared_size)
      : weights_(options.prior_weights),
        at_(options.prior_at.size() > 0 ? options.prior_at : Eigen::VectorXd::Zero(weights_.size())),
        shared_size_(shared_size) {
    set_num_residuals(static_cast<int>(weights_.size()));
    mutable_parameter_block_sizes()->push_back(shared_size + num_residuals());
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const auto x = Eigen::VectorXd::Map(parameters[0] + shared_size_, weights_.size());
    Eigen::VectorXd::Map(residuals, weights_.size()) = weights_.cwiseProduct(x - at_);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<RowMatrix> slope(jacobians[0], weights_.size(), shared_size_ + weights_.size());
      slope.setZero();
      slope.rightCols(weights_.size()).diagonal() = weights_;
    }
    return true;
  }

  /// The rows for the triangle of [shared unknowns | arm | residual] at x.
  [[nodiscard]] Eigen::MatrixXd rows(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(weights_.size(), shared_size_ + weights_.size() + 1);
    all.middleCols(shared_size_, weights_.size()).diagonal() = weights_;
    all.rightCols<1>() = weights_.cwiseProduct(x - at_);
    return all;
  }

 private:
  Eigen::VectorXd weights_, at_;
  int shared_size_;
};

/// Stops where a step moves nothing that matters, in the solver's physical units. Ceres' own tolerances are relative to
/// the parameters' norm, or to a cost that has come down to its rounding.
class StopWhenStill final : public ceres::IterationCallback {
 public:
  explicit StopWhenStill(double still) : still_(still) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    // A step that Ceres could not compute has the norm 0 too, and one that was cut short by a small trust region moves
    // nothing either: neither is a sign of convergence.
    const bool whole = summary.step_is_successful || summary.trust_region_radius > undamped;
    const bool is_still = summary.iteration > 0 && summary.step_is_valid && whole && summary.step_norm < still_;
    return is_still ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  double still_;
};

ceres::Solver::Options solver_options(const SolveOptions& options) {
  ceres::Solver::Options ceres_options;
  ceres_options.max_num_iterations = options.max_iterations;
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  // Gauss-Newton first; the region shrinks fast where that does not lower the cost.
  ceres_options.initial_trust_region_radius = 1e16;
  ceres_options.max_num_consecutive_invalid_steps = max_invalid_steps;
  ceres_options.parameter_tolerance = 1e-14;
  ceres_options.function_tolerance = 0.0;
  ceres_options.gradient_tolerance = 0.0;
  return ceres_options;
}

Termination termination_of(const ceres::Solver::Summary& summary) {
  if (summary.termination_type == ceres::CONVERGENCE || summary.termination_type == ceres::USER_SUCCESS) {
    return Termination::Converged;
  }
  return summary.IsSolutionUsable() ? Termination::NoConvergence : Termination::Failed;
}

/// The solver's numbers in one piece of memory: the groups' unknowns, then the shared ones and the arm's x.
/// Ceres orders parameter blocks of one elimination group by address; one piece makes that the order of the
/// groups, whatever the heap looks like, and so the sums and their bits the same on every run.
class Numbers {
 public:
  Numbers(const Eigen::VectorXd& x, const Unknowns& unknowns) {
    for (const GroupState& group : unknowns.groups) {
      append(group.values);
    }
    append(unknowns.shared);
    all_.insert(all_.end(), x.begin(), x.end());
  }
  double* group(std::size_t index) { return all_.data() + starts_[index]; }
  double* common() { return group(starts_.size() - 1); }

  void copy_to(Eigen::VectorXd& x_out, Unknowns& unknowns) {
    for (std::size_t g = 0; g < unknowns.groups.size(); ++g) {
      auto& values = unknowns.groups[g].values;
      values = Eigen::VectorXd::Map(group(g), values.size());
    }
    unknowns.shared = Eigen::VectorXd::Map(common(), unknowns.shared.size());
    x_out = Eigen::VectorXd::Map(common() + unknowns.shared.size(), x_out.size());
  }

 private:
  void append(const Eigen::VectorXd& values) {
    starts_.push_back(all_.size());
    all_.insert(all_.end(), values.begin(), values.end());
  }
  std::vector<double> all_;
  std::vector<std::size_t> starts_;
};

}  // namespace

Solution solve(const System& system, const Weights& weights, const Eigen::VectorXd& x_start, Unknowns start,
               const SolveOptions& options, const Linearisation* at_start) {
  Solution solution;
  solution.x = x_start;
  solution.unknowns = std::move(start);
  Numbers numbers(solution.x, solution.unknowns);
  const auto blocks = blocks_of(*system.constraints);
  solution.linearisation.shared = system.shared_size();
  solution.linearisation.triangles.resize(blocks.size());
  ceres::Problem problem;
  ceres::Solver::Options ceres_options = solver_options(options);
  StopWhenStill stop_when_still(options.still);
  ceres_options.callbacks.push_back(&stop_when_still);
  ceres_options.linear_solver_type = ceres::DENSE_QR;
  if (blocks.size() > 1) {
    ceres_options.linear_solver_type = ceres::DENSE_SCHUR;
    ceres_options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    ceres_options.linear_solver_ordering->AddElementToGroup(numbers.common(), 1);
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    GroupReference reference;
    std::vector<double*> parameter_blocks{numbers.common()};
    if (b > 0) {
      reference = solution.unknowns.groups[b - 1].reference;
      parameter_blocks.push_back(numbers.group(b - 1));
      ceres_options.linear_solver_ordering->AddElementToGroup(numbers.group(b - 1), 0);
    }
    auto cost = std::make_unique<BlockCost>(system, weights, options.loss, blocks[b], std::move(reference),
                                            at_start == nullptr ? nullptr : &at_start->triangles[b],
                                            solution.linearisation.triangles[b]);
    problem.AddResidualBlock(cost.release(), nullptr, parameter_blocks);
  }
  if (options.prior_weights.size() > 0) {
    problem.AddResidualBlock(new PriorCost(options, system.shared_size()), nullptr, numbers.common());
  }
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options, &problem, &summary);
  numbers.copy_to(solution.x, solution.unknowns);
  if (options.prior_weights.size() > 0 && summary.IsSolutionUsable()) {
    Eigen::MatrixXd& triangle = solution.linearisation.triangles.front();
    TriangularFactor factor(static_cast<int>(triangle.cols()));
    factor.add(triangle);
    factor.add(PriorCost(options, system.shared_size()).rows(solution.x));
    triangle = factor.triangle();
  }
  solution.termination = termination_of(summary);
  solution.iterations = static_cast<int>(summary.iterations.size()) - 1;
  solution.initial_cost = summary.initial_cost;
  solution.final_cost = summary.final_cost;
  solution.message = summary.termination_type == ceres::USER_SUCCESS
                         ? fmt::format("the last step moved nothing by {:g} mm", options.still)
                         : summary.message;
  return solution;
}

}  // namespace artcal
