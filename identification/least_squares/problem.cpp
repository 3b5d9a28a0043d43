#include "identification/least_squares/problem.h"

#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include <ceres/ceres.h>
#include <fmt/format.h>

#include "identification/least_squares/elimination.h"
#include "identification/least_squares/row_stack.h"
#include "identification/least_squares/rows.h"

namespace artcal {
namespace {

// Unknowns that remain after the elimination: beyond, their matrix is sparse enough to be treated as such.
constexpr int max_dense = 300;

/// Sweeps at the arm's x that was asked for last: Ceres evaluates all blocks at one x before it goes on.
class KinematicsAt {
 public:
  explicit KinematicsAt(const System& system) : system_(system) {}
  const std::vector<ForwardKinematics>& operator()(const double* x) {
    const auto at = Eigen::VectorXd::Map(x, system_.arm_size());
    if (kinematics_by_probe_.empty() || at != x_) {
      x_ = at;
      kinematics_by_probe_ = forward_kinematics_of(system_, system_.arm_at(x));
    }
    return kinematics_by_probe_;
  }

 private:
  const System& system_;
  Eigen::VectorXd x_;
  std::vector<ForwardKinematics> kinematics_by_probe_;
};

/// The solver's numbers in one piece of memory, as StateLayout has them.
/// Ceres orders parameter blocks of one elimination group by address; one piece makes that the order of the
/// groups, whatever the heap looks like, and so the sums and their bits the same on every run.
class Numbers {
 public:
  Numbers(const StateLayout& layout, const Eigen::VectorXd& x, const Unknowns& unknowns)
      : layout_(layout), all_(packed(layout, unknowns, x)) {}
  double* group(int index) { return all_.data() + layout_.groups[index]; }
  double* shared() { return all_.data() + layout_.common; }
  double* x() { return all_.data() + layout_.arm; }
  [[nodiscard]] const Eigen::VectorXd& all() const { return all_; }

  void copy_to(Eigen::VectorXd& x_out, Unknowns& unknowns) {
    unpack(layout_, all_, unknowns);
    x_out = Eigen::VectorXd::Map(x(), x_out.size());
  }

 private:
  const StateLayout& layout_;
  Eigen::VectorXd all_;
};

/// Tells, before Jacobians are computed, whether the step that led there is so short that the solve ends with it: then
/// none of them is looked at.
class LastStep final : public ceres::EvaluationCallback {
 public:
  LastStep(const Numbers& numbers, double still) : numbers_(numbers), still_(still) {}
  void PrepareForEvaluation(bool jacobians, bool /*new_point*/) override {
    if (!jacobians) {
      return;
    }
    is_last_ = last_.size() > 0 && (numbers_.all() - last_).norm() < still_;
    last_ = numbers_.all();
  }
  [[nodiscard]] bool is_last() const { return is_last_; }

 private:
  const Numbers& numbers_;
  double still_;
  Eigen::VectorXd last_;
  bool is_last_ = false;
};

/// One block of the linearisation as a Ceres cost. Parameter blocks: the arm's x, where there are any the group's
/// unknowns and the artefact parameters. Residuals and Jacobian are the last column of BlockRows and the others: cost,
/// gradient and normal matrix are those of all the readings behind them. Where only the cost is wanted, its root stands
/// in the first residual; so it does where the Jacobian would be looked at by nobody, and this is zero.
class BlockCost final : public ceres::CostFunction {
 public:
  BlockCost(const System& system, const Weights& weights, const SolveOptions& options, Block block,
            GroupReference reference, const double* shared, KinematicsAt& kinematics_by_probe,
            const LastStep* last_step, BlockRows& rows)
      : system_(system),
        weights_(weights),
        loss_(options.loss),
        folding_(options.folding),
        block_(std::move(block)),
        reference_(std::move(reference)),
        shared_(shared),
        kinematics_by_probe_(kinematics_by_probe),
        last_step_(last_step),
        rows_(rows) {
    set_num_residuals(max_rows(system, loss_, block_));
    for (const int size : {system.arm_size(), block_.unknowns, block_.parameters.size}) {
      if (size > 0) {
        mutable_parameter_block_sizes()->push_back(size);
      }
    }
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    int next = 0;
    const double* x = system_.arm_size() > 0 ? parameters[next++] : nullptr;
    const double* values = block_.unknowns > 0 ? parameters[next++] : nullptr;
    // Entries of other features are not looked at.
    const double* shared = block_.parameters.size > 0 ? parameters[next] - block_.parameters.first : shared_;
    const BlockPoint point{reference_, values, shared};
    Eigen::Map<Eigen::VectorXd> out(residuals, num_residuals());
    out.setZero();
    const bool is_last = last_step_ != nullptr && last_step_->is_last();
    if (jacobians == nullptr || is_last) {
      out[0] = std::sqrt(block_cost(system_, weights_, loss_, block_, kinematics_by_probe_(x), point));
    }
    if (jacobians == nullptr) {
      return true;
    }
    Eigen::MatrixXd& rows = rows_.rows;
    if (is_last) {
      rows.resize(0, rows.cols());
    } else {
      rows = block_rows(system_, weights_, loss_, block_, kinematics_by_probe_(x), point, folding_);
      out.head(rows.rows()) = rows.rightCols<1>();
    }
    next = 0;
    const auto put = [&](int first, int size) {
      if (size > 0 && jacobians[next] != nullptr) {
        Eigen::Map<RowMatrix> jacobian(jacobians[next], out.size(), size);
        jacobian.topRows(rows.rows()) = rows.middleCols(first, size);
        jacobian.bottomRows(out.size() - rows.rows()).setZero();
      }
      next += size > 0 ? 1 : 0;
    };
    put(block_.nuisance(), system_.arm_size());
    put(0, block_.unknowns);
    put(block_.unknowns, block_.parameters.size);
    return true;
  }

 private:
  const System& system_;
  const Weights& weights_;
  Loss loss_;
  Folding folding_;
  Block block_;
  GroupReference reference_;
  const double* shared_;
  KinematicsAt& kinematics_by_probe_;
  const LastStep* last_step_;  // null: each Jacobian is asked for
  BlockRows& rows_;            // the last evaluated: at the end, the solution's
};

// Trust regions above this leave the Gauss-Newton step as it is.
constexpr double undamped = 1e8;
// Steps that may fail in a row before Ceres gives up: from the region we begin with down to one that damps any system.
constexpr int max_invalid_steps = 20;

/// Pseudo-observations of the arm's steps, each with its weight.
class PriorCost final : public ceres::CostFunction {
 public:
  explicit PriorCost(const SolveOptions& options)
      : weights_(options.prior_weights),
        at_(options.prior_at.size() > 0 ? options.prior_at : Eigen::VectorXd::Zero(weights_.size())) {
    set_num_residuals(static_cast<int>(weights_.size()));
    mutable_parameter_block_sizes()->push_back(num_residuals());
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const auto x = Eigen::VectorXd::Map(parameters[0], weights_.size());
    Eigen::VectorXd::Map(residuals, weights_.size()) = weights_.cwiseProduct(x - at_);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<RowMatrix>(jacobians[0], weights_.size(), weights_.size()) = weights_.asDiagonal();
    }
    return true;
  }

  /// The rows of [arm | residual] at x.
  [[nodiscard]] Eigen::MatrixXd rows(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(weights_.size(), weights_.size() + 1);
    all.leftCols(weights_.size()).diagonal() = weights_;
    all.rightCols<1>() = weights_.cwiseProduct(x - at_);
    return all;
  }

 private:
  Eigen::VectorXd weights_, at_;
};

/// Stops where a step moves nothing that matters, in the solver's physical units. Ceres' own tolerances are relative to
/// the parameters' norm, or to a cost that has come down to its rounding.
class StopWhenStill final : public ceres::IterationCallback {
 public:
  StopWhenStill(double still, const LastStep* last_step) : still_(still), last_step_(last_step) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    // A step that Ceres could not compute has the norm 0 too, and one that was cut short by a small trust region moves
    // nothing either: neither is a sign of convergence.
    const bool whole = summary.step_is_successful || summary.trust_region_radius > undamped;
    const bool is_still = summary.iteration > 0 && summary.step_is_valid && whole && summary.step_norm < still_;
    const bool is_last = last_step_ != nullptr && last_step_->is_last();  // the same but for the norm's last bit
    return is_still || is_last ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  double still_;
  const LastStep* last_step_;
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

// The leaves of all components are eliminated first; what remains is solved for densely where it is small.
void choose_linear_solver(const std::vector<BlockRows>& blocks, int arm_size, Numbers& numbers,
                          ceres::Solver::Options& options) {
  options.linear_solver_type = ceres::DENSE_QR;
  if (blocks.size() < 2) {
    return;
  }
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  int left = arm_size;
  if (arm_size > 0) {
    ordering->AddElementToGroup(numbers.x(), 1);
  }
  std::map<int, int> size_of_group;
  for (const BlockRows& block : blocks) {
    size_of_group[block.group] = block.unknowns;
  }
  for (const Component& component : components_of(blocks)) {
    for (const int group : component.groups) {
      ordering->AddElementToGroup(numbers.group(group), component.groups_are_leaves ? 0 : 1);
      left += component.groups_are_leaves ? 0 : size_of_group[group];
    }
    for (const FeatureParameters& parameters : component.parameters) {
      ordering->AddElementToGroup(numbers.shared() + parameters.first, component.groups_are_leaves ? 1 : 0);
      left += component.groups_are_leaves ? parameters.size : 0;
    }
  }
  options.linear_solver_type = left <= max_dense ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.linear_solver_ordering = ordering;
}

}  // namespace

Solution solve(const System& system, const Weights& weights, const Eigen::VectorXd& x_start, Unknowns start,
               const SolveOptions& options) {
  Solution solution;
  solution.x = x_start;
  solution.unknowns = std::move(start);
  const auto blocks = blocks_of(*system.constraints);
  Linearisation& linearisation = solution.linearisation;
  linearisation.layout = layout_of(*system.constraints, system.arm_size());
  Numbers numbers(linearisation.layout, solution.x, solution.unknowns);
  for (const Block& block : blocks) {
    linearisation.blocks.push_back({block.group, block.unknowns, block.parameters, {}});
  }
  KinematicsAt kinematics_by_probe(system);
  LastStep last_step(numbers, options.still);
  LastStep* const asked = options.linearise_solution ? nullptr : &last_step;
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = asked;
  ceres::Problem problem(problem_options);
  ceres::Solver::Options ceres_options = solver_options(options);
  StopWhenStill stop_when_still(options.still, asked);
  ceres_options.callbacks.push_back(&stop_when_still);
  choose_linear_solver(linearisation.blocks, system.arm_size(), numbers, ceres_options);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    if (max_rows(system, options.loss, block) == 0) {
      linearisation.blocks[b].rows.resize(0, block.nuisance() + system.arm_size() + 1);
      continue;
    }
    std::vector<double*> parameter_blocks;
    if (system.arm_size() > 0) {
      parameter_blocks.push_back(numbers.x());
    }
    if (block.unknowns > 0) {
      parameter_blocks.push_back(numbers.group(block.group));
    }
    if (block.parameters.size > 0) {
      parameter_blocks.push_back(numbers.shared() + block.parameters.first);
    }
    const GroupReference reference =
        block.group < 0 ? GroupReference{} : solution.unknowns.groups[block.group].reference;
    auto cost = std::make_unique<BlockCost>(system, weights, options, block, reference, numbers.shared(),
                                            kinematics_by_probe, asked, linearisation.blocks[b]);
    problem.AddResidualBlock(cost.release(), nullptr, parameter_blocks);
  }
  if (options.prior_weights.size() > 0) {
    problem.AddResidualBlock(new PriorCost(options), nullptr, numbers.x());
  }
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options, &problem, &summary);
  numbers.copy_to(solution.x, solution.unknowns);
  if (options.prior_weights.size() > 0 && summary.IsSolutionUsable()) {
    Eigen::MatrixXd& rows = linearisation.blocks.front().rows;  // those without nuisance unknowns
    RowStack stack(static_cast<int>(rows.cols()));
    stack.add(rows);
    stack.add(PriorCost(options).rows(solution.x));
    rows = stack.rows();
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
