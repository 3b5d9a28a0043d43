#pragma once

#include <Eigen/Core>

#include "core/error.h"
#include "identification/least_squares/arm_fit.h"

namespace artcal {

/// What covariances lack where certified distances are read in several placements.
struct CommonErrors {
  Eigen::VectorXd of_shared;  ///< variances of Constraints::shared, mm²
  Eigen::MatrixXd of_arm;     ///< of the free parameters, mm and rad
};

/// The least squares take the error of a distance for a
/// new one in each placement, but it is the certificate's, one for all of them, and that of an artefact's expansion is
/// one for all its lengths. With aₚ their answer to one standard deviation in placement p this is (Σ aₚ)(Σ aₚ)ᵀ − Σ
/// aₚaₚᵀ, summed over all such errors (JCGM 100 §5.2.2, fully correlated inputs). `system` is make_system() at the arm
/// of the fit. No solution: see ArrowFactor.
Expected<CommonErrors> correlated_certificate_errors(const System& system, const ArmFit& fit,
                                                     const Recording& recording);

}  // namespace artcal
