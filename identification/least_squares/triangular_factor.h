#pragma once

#include <cstddef>
#include <memory>

#include <Eigen/Core>

#include "identification/least_squares/kernels/reflection.h"

namespace artcal {

/// Rows of a matrix, wherever and in whatever order they lie in memory. Refers to them: no Eigen::Ref, which copies
/// what is stored row by row.
class RowsRef {
 public:
  template <typename Derived>
  RowsRef(const Eigen::MatrixBase<Derived>& rows)  // NOLINT(google-explicit-constructor): as Eigen::Ref
      : data_(rows.derived().data()),
        rows_(rows.rows()),
        columns_(rows.cols()),
        row_stride_(rows.derived().rowStride()),
        column_stride_(rows.derived().colStride()) {}

  [[nodiscard]] Eigen::Index rows() const { return rows_; }
  [[nodiscard]] Eigen::Index columns() const { return columns_; }
  [[nodiscard]] const double* row(Eigen::Index r) const { return data_ + r * row_stride_; }
  /// From one number of a row to the next.
  [[nodiscard]] std::ptrdiff_t column_stride() const { return column_stride_; }
  [[nodiscard]] auto matrix() const {
    using Strides = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
    return Eigen::Map<const Eigen::MatrixXd, 0, Strides>(data_, rows_, columns_, Strides(column_stride_, row_stride_));
  }

 private:
  const double* data_;
  Eigen::Index rows_, columns_;
  std::ptrdiff_t row_stride_, column_stride_;
};

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
  std::unique_ptr<RowPairs[]> waiting_;  // of each group all pairs of rows; the first filled_ rows are not yet folded
  Eigen::Index filled_ = 0;
};

/// What rows [N | A] over nuisance and wanted columns say of the wanted ones alone: the rows of A
/// left when the range of N is projected out. N may be rank deficient.
Eigen::MatrixXd eliminate_leading(const Eigen::MatrixXd& rows, int nuisance_columns);

}  // namespace artcal
