#pragma once

#include <Eigen/Core>

namespace artcal::fitting {

/// A matrix of a few rows whose size is known at run time only, without a heap. The decompositions below are
/// compiled once for all sizes: one for each size took half of the time that this folder needs to compile.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 16, 8>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 16, 1>;

/// The x that minimises ‖A·x − b‖, by QR with column pivoting; directions that A does not see get zero.
SmallVector least_squares_solution(const SmallMatrix& a, const SmallVector& b);

/// Singular values, largest first, and the right singular vectors (columns) of a square matrix.
struct SmallSvd {
  SmallVector values;
  SmallMatrix right_vectors;
};
SmallSvd small_svd(const SmallMatrix& square);

}  // namespace artcal::fitting
