#include "identification/inspection/as_written.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/evaluation/misfit.h"
#include "identification/inspection/hypotheses/hypothesis.h"

namespace artcal {
namespace {

constexpr double gross_by_reach = 0.01;
constexpr double min_noise_ratio = 3.0;
constexpr double min_size = 0.02;              // mm, where the noise is stated
constexpr double min_size_of_unstated = 0.05;  // mm

}  // namespace

double residual_size(const Estimate& estimate, const IdentifyOptions& options) {
  return estimate.fit.noise * (options.noise.is_given() ? noise_ratio(estimate.fit, options.loss) : 1.0);
}

IdentifyOptions for_trial(const IdentifyOptions& options) {
  IdentifyOptions trial = options;
  trial.leave_out = false;
  trial.loss = Loss::None;
  trial.progress = {};
  trial.start.reset();
  return trial;
}

bool is_another_arm(const Arm& nominal, const Arm& found) {
  return !is_plausible(nominal, found, parameters_with_radii(nominal));
}

bool is_misfit(const Error& error) {
  return error.code == ErrorCode::NoSolution &&
         (error.kind == ErrorKind::Misfit || error.kind == ErrorKind::NoConvergence);
}

AsWritten fit_as_written(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options) {
  const auto estimate = search_solution(recording, constraints, for_trial(options));
  if (!estimate) {
    const bool gross = discrepancy({recording, constraints}, recording.arm) > gross_by_reach * reach(recording.arm);
    const bool misfit = is_misfit(estimate.error()) || (estimate.error().code == ErrorCode::NoSolution && gross);
    return {misfit ? std::numeric_limits<double>::infinity() : 0.0, misfit, std::nullopt};
  }
  const bool misfit = !estimate->misfits.empty();
  return {residual_size(*estimate, options), misfit, estimate->fit.arm,
          misfit && is_another_arm(recording.arm, estimate->fit.arm), misfit ? estimate->misfits.front() : ""};
}

bool is_unexplained(const AsWritten& as_written, const Recording& recording, const IdentifyOptions& options) {
  if (as_written.is_misfit) {
    return true;
  }
  if (options.noise.reading) {
    return as_written.size > std::max(min_size, min_noise_ratio * *options.noise.reading);
  }
  const double stated = options.noise.is_given()
                            ? std::hypot(*options.noise.probing, 0.5 * *options.noise.encoder * reach(recording.arm))
                            : 0.0;
  return as_written.size >
         (options.noise.is_given() ? std::max(min_size, min_noise_ratio * stated) : min_size_of_unstated);
}

}  // namespace artcal
