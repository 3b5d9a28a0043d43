#pragma once

#include <vector>

#include <Eigen/Core>

namespace artcal {

/// The rows of one observation in a projected system, and what the fit took of them.
struct ObservationRows {
  Eigen::Index first = 0;
  Eigen::MatrixXd hat;  ///< its diagonal block of the hat matrix; as many rows as the observation has
  /// Observations of the same unit have a common error, such as one certified distance in all placements; units are
  /// independent of one another. Units count from 0.
  int unit = 0;
};

/// Residuals divided by what the fit leaves of them: (1 − H)^(−½)·r of each observation with its own block of H, so
/// that their products have the expectation of the errors' covariance where all errors have one variance (CR2: Bell,
/// McCaffrey, Survey Methodology 28 (2002) 169). Directions that the fit adapts to wholly become zero.
Eigen::VectorXd leverage_adjusted(const Eigen::VectorXd& residuals, const std::vector<ObservationRows>& observations);

/// Test that residuals contain no part along `columns` (orthonormal, with the fit projected out, as the residuals): the
/// score S = Qᵀr against its covariance V = Σ sᵤsᵤᵀ from the scores of the units themselves. Errors may differ from
/// reading to reading and be correlated within a reading, as encoder noise makes those of a tip; an F test takes them
/// for independent and of one variance, and finds effects that are none. SᵀV⁻¹S is χ² of as many degrees of freedom as
/// there are columns with many units, and exceeds its high quantiles less often with few, where one unit outweighs the
/// others (a self-normalised sum: Efron, J. Am. Stat. Assoc. 64 (1969) 1278).
/// 0 where there are fewer units than columns plus ten.
double score_statistic(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residuals,
                       const Eigen::VectorXd& adjusted, const std::vector<ObservationRows>& observations);

}  // namespace artcal
