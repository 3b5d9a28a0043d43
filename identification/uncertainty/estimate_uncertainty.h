#pragma once

#include <Eigen/Core>

#include "identification/estimation.h"
#include "identification/evaluation/goodness_of_fit.h"
#include "identification/uncertainty/correlated_errors.h"

namespace artcal {

/// What readings and certificates leave uncertain of an estimate.
struct EstimateUncertainty {
  Eigen::MatrixXd of_readings;   ///< covariance of the free parameters, each certificate's error new in each placement
  CommonErrors of_certificates;  ///< what that lacks
  Redundancy redundancy;
  GoodnessOfFit goodness_of_fit;
  double scale_factor = 1.0;  ///< on standard uncertainties: how many times a stated noise the residuals are (Birge)

  /// Of the free parameters, mm and rad.
  [[nodiscard]] Eigen::MatrixXd covariance() const {
    return scale_factor * scale_factor * (of_readings + of_certificates.of_arm);
  }
};

/// `system` is make_system() at the arm of the estimate.
/// No solution: the readings do not determine the free parameters there.
Expected<EstimateUncertainty> uncertainty_of(const System& system, const Estimate& estimate, const Recording& recording,
                                             const IdentifyOptions& options);

}  // namespace artcal
