#include "identification/identifiability/svd.h"

#include <Eigen/SVD>

namespace artcal {

Svd svd(const Eigen::MatrixXd& matrix) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(matrix, Eigen::ComputeFullV);
  return {decomposition.singularValues(), decomposition.matrixV()};
}

}  // namespace artcal
