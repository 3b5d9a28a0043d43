#pragma once

#include <string>
#include <vector>

#include "identification/identify.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/uncertainty/redundancy.h"

namespace artcal {

/// |r| of an observation of `dimension` weighted residuals whose squares sum to `squares`, in such units that it is the
/// root of a χ² with Check::freedom degrees of freedom (an internally studentised residual, or of an observation that
/// was let go of the deleted one). 0 where the fit adapts to it.
double standardised(double squares, int dimension, const Check& check);

/// What 1 − 0.05/count of sound observations stay below.
double outlier_limit(double count, const Check& check);

/// Observations that can be outliers: readings, binding distances, certified numbers.
double observation_count(const Constraints& constraints);

struct Outliers {
  std::vector<Outlier> readings;
  std::vector<CertificateOutlier> certificates;
};

/// Readings and certified values whose standardised residual is larger than one in twenty sound recordings would show
/// anywhere. The worst first. They are listed, never left out; a loss may have let go of them. Readings of a feature
/// whose certified value is further off than they are not listed: the certificate is what bends them.
/// `redundancy` is that of the fit.
Outliers find_outliers(const Recording& recording, const Constraints& constraints, const ArmFit& fit,
                       const Redundancy& redundancy, const Evaluation& evaluation);

/// What a person is to know of outlying certificates; empty where there are none.
std::string warning_of(const std::vector<CertificateOutlier>& certificates, Loss loss);

}  // namespace artcal
