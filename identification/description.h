#pragma once

#include <vector>

#include "identification/least_squares/arm_fit.h"
#include "identification/problem/preparation.h"
#include "identification/uncertainty/correlated_errors.h"

namespace artcal {

/// Every parameter of the arm, and what became of it; `covariance` is of Preparation::free.
std::vector<IdentifiedParameter> describe(const Arm& nominal, const Arm& identified, const Preparation& preparation,
                                          const Eigen::MatrixXd& covariance);

/// What a fit says of the numbers of the artefacts themselves; `common` from correlated_certificate_errors(), `scale
/// factor` as in Identification.
std::vector<ArtefactValue> describe_artefacts(const Constraints& constraints, const ArmFit& fit,
                                              const CommonErrors& common, double scale_factor);

}  // namespace artcal
