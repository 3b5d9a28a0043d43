#pragma once

#include <Eigen/Core>

namespace artcal {

/// Singular values, largest first, and all right singular vectors (columns) of a small matrix.
struct Svd {
  Eigen::VectorXd values;
  Eigen::MatrixXd right_vectors;
};

/// By two-sided Jacobi rotations, which keep small singular values accurate. The one place where the
/// decomposition is compiled.
Svd svd(const Eigen::MatrixXd& matrix);

}  // namespace artcal
