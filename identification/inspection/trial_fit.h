#pragma once

#include <limits>
#include <optional>

#include "identification/inspection/as_written.h"
#include "identification/inspection/hypotheses/hypothesis.h"

namespace artcal {

/// A hypothesis and what the search for an arm makes of it.
struct Trial {
  Hypothesis hypothesis;
  double size = std::numeric_limits<double>::infinity();
  Arm arm = {};
  bool is_sure_by_nominal = false;  ///< the nominal arm is ten times nearer to the readings as the hypothesis has them
  bool is_as_stated = false;        ///< the residuals are of the size of the stated noise
};

/// Fits recordings as hypotheses have them, and compares with the recording as it is written.
class TrialFits {
 public:
  TrialFits(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
            const AsWritten& as_written);

  /// Whether the search for an arm, from `start` where it is given, leads to a solution that explains the readings far
  /// better than what is written: a quarter of the residuals or less. Where the readings as written fit another arm
  /// than that of the file (a joint that counts the other way round is an alpha 180 degrees off, a length in inch an
  /// arm a twenty-fifth as long), a number or a choice explains them that leads back to the file's arm, with residuals
  /// as small and no larger than a sound recording's. Fills `trial`.
  bool explains(Trial& trial, const std::optional<Arm>& start = {}) const;

  /// Whether a trial that explains the readings makes any other hypothesis idle: a choice or a number that leaves the
  /// stated noise, or next to nothing of the residuals, or leads back to the file's arm.
  [[nodiscard]] bool is_enough(const Trial& trial) const;

 private:
  [[nodiscard]] bool may_fit(const Trial& trial, const Bound& bound, const IdentifyOptions& options) const;
  [[nodiscard]] bool restores_the_arm(const Trial& trial) const;

  const Recording& recording_;
  const Constraints& constraints_;
  const IdentifyOptions& options_;
  const AsWritten& as_written_;
  double comparable_ = 0.0;  ///< the residuals as written, by an arm of the file's size, mm a coordinate
};

}  // namespace artcal
