#include "fitting/small_matrix.h"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace artcal::fitting {

SmallVector least_squares_solution(const SmallMatrix& a, const SmallVector& b) {
  return Eigen::ColPivHouseholderQR<SmallMatrix>(a).solve(b);
}

SmallSvd small_svd(const SmallMatrix& square) {
  const Eigen::JacobiSVD<SmallMatrix, Eigen::NoQRPreconditioner> svd(square, Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixV()};
}

}  // namespace artcal::fitting
