#pragma once

#include <vector>

#include <Eigen/Core>

#include "identification/least_squares/kernels/reflection.h"

namespace artcal {

/// Rows of a matrix, wherever and in whatever order they lie in memory.
using RowsRef = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>;

/// The triangular factor R of a tall matrix that never stands in memory as a whole: rows come in blocks,
/// each block is folded into R by Householder reflections (a QR in a chain; Golub, Van Loan 2013, §6.5.3).
/// RᵀR = AᵀA, but R comes from A itself, so that its singular values are A's to full precision. The result
/// depends on the order of the rows only in the last digits; the order is fixed, so the bits are too.
class TriangularFactor {
 public:
  explicit TriangularFactor(int columns);

  void add(const RowsRef& rows);

  /// columns × columns, upper triangular.
  [[nodiscard]] Eigen::MatrixXd triangle();

 private:
  void fold();

  Eigen::Index columns_;
  Eigen::Index groups_;  // of four columns; those that are too many are zero
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> triangle_;
  std::vector<RowPairs> waiting_;  // of each group all pairs of rows; the first filled_ rows are not yet folded
  Eigen::Index filled_ = 0;
};

/// What rows [N | A] over nuisance and wanted columns say of the wanted ones alone: the rows of A
/// left when the range of N is projected out. N may be rank deficient.
Eigen::MatrixXd eliminate_leading(const Eigen::MatrixXd& rows, int nuisance_columns);

}  // namespace artcal
