#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/identify.h"
#include "identification/inspection/finding.h"

namespace artcal {

/// How well the recording as it is written can be fitted.
struct AsWritten {
  double size = 0.0;       ///< of the residuals of the best fit, mm a coordinate; infinite: no fit
  bool is_misfit = false;  ///< that fit is no solution (identification/evaluation/misfit.h)
  std::optional<Arm> arm;  ///< of that fit
};

/// Whether an identification without a solution ended because no arm fits the readings, and not because they do not
/// determine one.
bool is_misfit(const Error& error);

/// The best fit to the recording as it is written. Where the readings do not determine an arm, a misfit only if the
/// nominal arm is off by more than a hundredth of its reach.
AsWritten fit_as_written(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options);

/// What one mistake explains, and which mistakes were looked for in vain.
struct Explanation {
  std::optional<Finding> finding;
  std::vector<std::string> excluded;
};

/// Whether the residuals are large enough to look for a mistake: a misfit, or more than three times the stated noise,
/// or, where none is stated, more than any coordinate measuring arm has.
bool is_unexplained(const AsWritten& as_written, const Recording& recording, const IdentifyOptions& options);

/// Tries what a recording would be without one mistake: angles, their order and signs, lengths and their units, radii,
/// labels, tables, a slipped encoder. The gross ones are ranked by the nominal arm, the others by quick fits. One is
/// named only where the whole search for an arm with it leaves a quarter of the residuals at most, and is a solution.
Explanation explain(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                    const AsWritten& as_written);

/// The same for diameters and radii alone, which takes a few fits.
Explanation explain_by_radii(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                             const AsWritten& as_written);

}  // namespace artcal
