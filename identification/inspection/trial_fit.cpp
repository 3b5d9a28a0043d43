#include "identification/inspection/trial_fit.h"

#include <algorithm>

#include "identification/estimation.h"
#include "identification/evaluation/misfit.h"
#include "identification/initial/faint_turns.h"
#include "identification/initial/initial_alignment.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/problem/preparation.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

constexpr double far_better = 4.0;
constexpr double surely_better = 30.0;
constexpr double as_good_as_written = 1.5;
constexpr double surely_as_stated = 2.0;
constexpr double worth_a_search = 2.0;
constexpr int quick_iterations = 30;

// Root mean square of the residuals after a few iterations, whether or not they converged, mm a coordinate.
std::optional<double> left_by_few_iterations(const Bound& bound, const Preparation& preparation,
                                             const SolveOptions& few) {
  const System system = make_system(bound.recording, bound.constraints, preparation.start, preparation.free);
  const auto unknowns = estimate_nuisance_parameters(system, preparation.start, bound.recording);
  const int degrees_of_freedom =
      bound.constraints.residual_count() - bound.constraints.unknown_count() - system.arm_size();
  if (!unknowns || degrees_of_freedom < 1) {
    return std::nullopt;
  }
  const Weights weights = unit_weights(bound.constraints);
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(system.arm_size());
  Solution solution = solve(system, weights, start, *unknowns, patient_options(bound.constraints, few));
  solution = with_corrected_turns(std::move(solution), system, bound.recording, weights, start, few);
  if (solution.termination == Termination::Failed) {
    return std::nullopt;
  }
  const auto residuals = whitened_residuals(system, weights, system.arm_at(solution.x.data()), solution.unknowns);
  return std::sqrt(residuals.readings_squared() / degrees_of_freedom);
}

}  // namespace

TrialFits::TrialFits(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                     const AsWritten& as_written)
    : recording_(recording),
      constraints_(constraints),
      options_(options),
      as_written_(as_written),
      comparable_(as_written.size) {
  if (as_written.is_another_arm && as_written.arm) {
    comparable_ *= std::max(1.0, reach(recording.arm) / reach(*as_written.arm));
  }
}

bool TrialFits::explains(Trial& trial, const std::optional<Arm>& start) const {
  auto bound = applied(trial.hypothesis, recording_, constraints_.artefacts);
  if (!bound) {
    return false;
  }
  IdentifyOptions options = options_;
  options.start = start;
  options.model.insert(options.model.end(), trial.hypothesis.model.begin(), trial.hypothesis.model.end());
  if (!may_fit(trial, *bound, options)) {
    return false;
  }
  const auto estimate = search_solution(bound->recording, bound->constraints, options);
  if (!estimate || !estimate->misfits.empty()) {
    return false;
  }
  trial.is_as_stated = options.noise.is_given() && noise_ratio(estimate->fit, options.loss) < surely_as_stated;
  trial.size = residual_size(*estimate, options);
  trial.arm = estimate->fit.arm;
  return trial.size * far_better <= comparable_ || restores_the_arm(trial);
}

bool TrialFits::is_enough(const Trial& trial) const {
  return trial.hypothesis.complexity <= 1 &&
         (trial.size * surely_better <= comparable_ || trial.is_as_stated || restores_the_arm(trial));
}

// One fit from the most promising initial alignment, before the whole search. Directions that the readings hardly
// determine take hundreds of iterations: of a hypothesis that the nominal arm speaks for, what a few leave counts.
bool TrialFits::may_fit(const Trial& trial, const Bound& bound, const IdentifyOptions& options) const {
  const auto alignments =
      alignments_for(bound.recording, bound.constraints, arm_for(options.model, bound.recording.arm));
  const auto preparation =
      options.start ? prepare_from(arm_for(options.model, *options.start), bound.recording, bound.constraints, options)
                    : prepare(bound.recording, bound.constraints, options, alignments.front());
  if (!preparation) {
    return false;
  }
  const double enough = as_written_.is_another_arm ? worth_a_search * comparable_ : comparable_ / worth_a_search;
  SolveOptions few;
  few.max_iterations = quick_iterations;
  if (const auto fit = fit_arm(bound.recording, bound.constraints, preparation->start, preparation->free, {}, few)) {
    return fit->noise <= enough;
  }
  if (!trial.is_sure_by_nominal) {
    return false;
  }
  const auto left = left_by_few_iterations(bound, *preparation, few);
  return left && *left <= std::min(enough, worth_a_search * largest_possible_noise(recording_.arm));
}

bool TrialFits::restores_the_arm(const Trial& trial) const {
  return as_written_.is_another_arm && trial.hypothesis.complexity <= 1 &&
         trial.size <= as_good_as_written * comparable_ &&
         !is_unexplained({trial.size, false, trial.arm}, recording_, options_);
}

}  // namespace artcal
