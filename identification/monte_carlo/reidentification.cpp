#include "identification/monte_carlo/reidentification.h"

#include <algorithm>
#include <cmath>

namespace artcal {
namespace {

// It ends where what is left of the way, judged by how fast steps shrink, is a hundred-thousandth of a standard
// deviation, or where a step is below what coordinates of a metre can show.
constexpr double still = 1e-5;
constexpr double nothing = 1e-10;  // mm, physical units
constexpr int max_steps_of_a_trial = 40;
// A step against the one before: longer, and the matrix is made anew.
constexpr double short_enough = 0.3;

}  // namespace

Expected<Reidentification> Reidentification::of(const System& system, const ArmFit& fit, const SolveOptions& options) {
  Reidentification again;
  again.system_ = &system;
  again.fit_ = &fit;
  again.options_ = options;
  again.layout_ = layout_of(*system.constraints, system.arm_size());
  auto factor = ArrowFactor::of(linearise(system, fit.weights, options.loss, fit.arm, fit.unknowns));
  if (!factor) {
    return tl::unexpected(factor.error());
  }
  again.factor_ = std::move(*factor);
  again.start_ = packed(again.layout_, fit.unknowns, Eigen::VectorXd::Zero(system.arm_size()));
  return again;
}

Unknowns Reidentification::unknowns_at(const Eigen::VectorXd& numbers) const {
  Unknowns unknowns = fit_->unknowns;
  unpack(layout_, numbers, unknowns);
  return unknowns;
}

Reidentification::Answer Reidentification::solve(const System& drawn, Scratch& scratch) const {
  Answer answer;
  Eigen::VectorXd numbers = start_;
  std::optional<ArrowFactor> nearer;
  double last = 0.0;
  bool shrinks = false;
  while (answer.steps < max_steps_of_a_trial) {
    ArrowFactor::Step step;
    if (answer.steps > 0 && !shrinks) {
      const Linearisation here = linearise(drawn, fit_->weights, options_.loss, scratch.gradient.blocks,
                                           drawn.arm_at(numbers.data() + layout_.arm), unknowns_at(numbers),
                                           Folding::NormalEquations);  // for steps only
      auto factor = ArrowFactor::of(here, Folding::NormalEquations);
      if (!factor) {
        break;
      }
      nearer = std::move(*factor);
      step = nearer->solve(gradient(here));
      ++answer.matrices;
    } else {
      const Eigen::VectorXd slope =
          gradient(drawn, fit_->weights, options_.loss, layout_, fit_->unknowns, numbers, scratch.gradient);
      step = (nearer ? *nearer : *factor_).solve(slope);
    }
    ++answer.steps;
    numbers -= step.numbers;
    const double shrinking = answer.steps > 1 ? step.length / last : 1.0;
    if (step.length * std::clamp(shrinking, 0.05, 1.0) < still || step.numbers.norm() < nothing) {
      answer.converged = true;
      answer.x = numbers.tail(layout_.size - layout_.arm);
      return answer;
    }
    if (!std::isfinite(step.length) || (answer.steps > 3 && step.length > 10.0 * last)) {
      break;
    }
    shrinks = answer.steps > 1 && shrinking < short_enough;
    last = step.length;
  }
  answer.by_solver = true;
  const Eigen::VectorXd x = Eigen::VectorXd::Zero(layout_.size - layout_.arm);
  const Solution solution = artcal::solve(drawn, fit_->weights, x, fit_->unknowns, options_);
  answer.converged = solution.termination == Termination::Converged && solution.x.allFinite();
  answer.steps += solution.iterations;
  answer.x = solution.x;
  return answer;
}

}  // namespace artcal
