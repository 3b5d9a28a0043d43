#include "acquisition/arm/covariance_matrix.h"

#include <Eigen/Eigenvalues>

namespace artcal {

bool is_covariance(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) {
    return true;
  }
  const Eigen::VectorXd u = matrix.diagonal().cwiseMax(0.0).cwiseSqrt();
  if (!matrix.allFinite() || !(u.minCoeff() > 0.0)) {
    return false;
  }
  const Eigen::MatrixXd correlation = u.cwiseInverse().asDiagonal() * matrix * u.cwiseInverse().asDiagonal();
  if (!correlation.isApprox(correlation.transpose(), 1e-9)) {
    return false;
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(correlation).eigenvalues().minCoeff() > -1e-9;
}

}  // namespace artcal
