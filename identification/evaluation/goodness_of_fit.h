#pragma once

#include "identification/least_squares/arm_fit.h"

namespace artcal {

/// χ² of a fit's residuals and what chance makes of it.
struct GoodnessOfFit {
  double chi_squared = 0.0;
  int degrees_of_freedom = 0;
  double low = 0.0, high = 0.0;  ///< 95 % of sound fits lie between them

  /// How many times the noise in use the residuals are: the root of χ² by its degrees of freedom, with a loss
  /// median_noise_factor(), because ψ is bounded and would not grow with them.
  double ratio = 1.0;
};

/// Least squares: the sum of the squared weighted residuals. With a loss the observations beyond outlier_limit() are
/// neither in χ² nor in its degrees of freedom, and the others count by ψ² over its expectation under normal noise,
/// whose variance gives the limits: readings that were let go of say nothing of the noise of the others.
GoodnessOfFit goodness_of_fit(const Constraints& constraints, const ArmFit& fit, Loss loss,
                              const Redundancy& redundancy);

}  // namespace artcal
