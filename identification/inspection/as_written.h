#pragma once

#include <optional>
#include <string>

#include "identification/estimation.h"
#include "identification/identify.h"

namespace artcal {

/// How well the recording as it is written can be fitted.
struct AsWritten {
  double size = 0.0;       ///< of the residuals of the best fit, mm a coordinate; infinite: no fit
  bool is_misfit = false;  ///< that fit is no solution (identification/evaluation/misfit.h)
  std::optional<Arm> arm;  ///< of that fit
  /// That arm is another than the file's: a parameter moved by more than any arm's does (is_plausible()). Its residuals
  /// may be small then, and say nothing.
  bool is_another_arm = false;
  std::string reason = {};  ///< why it is no solution
};

/// Whether an identification without a solution ended because no arm fits the readings, and not because they do not
/// determine one.
bool is_misfit(const Error& error);

/// The best fit to the recording as it is written. Where the readings do not determine an arm, a misfit only if the
/// nominal arm is off by more than a hundredth of its reach.
AsWritten fit_as_written(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options);

/// Whether a parameter of `found` is further from the file's than any arm's.
bool is_another_arm(const Arm& nominal, const Arm& found);

/// Size of an estimate's residuals, mm a coordinate: the noise that they show.
double residual_size(const Estimate& estimate, const IdentifyOptions& options);

/// Options for a fit that is only compared with others: plain least squares, from the initial alignments, nothing left
/// out and nobody told.
IdentifyOptions for_trial(const IdentifyOptions& options);

/// Whether the residuals are large enough to look for a mistake: a misfit, or more than three times the stated noise,
/// or, where none is stated, more than any coordinate measuring arm has.
bool is_unexplained(const AsWritten& as_written, const Recording& recording, const IdentifyOptions& options);

}  // namespace artcal
