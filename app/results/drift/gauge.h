#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// The parameters of an identified arm with their gauge freedom: combinations that the readings do not determine, in
/// each of which a parameter is fixed. Which one is, and at which value, moves the others.
struct GaugedParameters {
  std::vector<std::string> names;       ///< of all parameters
  std::vector<bool> is_angle;           ///< of each: rad, otherwise mm or a ratio
  Eigen::VectorXd values;               ///< of each, mm or rad
  std::vector<Eigen::Index> estimated;  ///< which are estimated, ascending; all others are fixed
  Eigen::MatrixXd covariance;           ///< of these
  Eigen::MatrixXd unidentifiable;       ///< by all parameters, a column for each combination that no reading sees
};

/// The parameters of one arm stated in the gauge of another.
struct InGauge {
  std::string not_comparable;      ///< why there is no such statement; empty where there is
  std::vector<std::string> moved;  ///< fixed parameters whose value differed
  Eigen::VectorXd values;          ///< of all parameters
  Eigen::MatrixXd covariance;      ///< of those that `first` estimates
};

/// `later` moved along its unidentifiable combinations to where the parameters that are fixed in `first` have the
/// values that they have there: no reading of either sees the difference. The combinations change along the way; the
/// mean of both ends' is right to the second order. The third, about φ³/6 where axes turn by φ, is added to the
/// covariance. Not comparable: other parameters, parameters that are fixed in one only or at different values and of
/// which no combination is unidentifiable in both.
InGauge in_gauge_of(const GaugedParameters& first, const GaugedParameters& later);

}  // namespace artcal
