#pragma once

#include <algorithm>

#include <Eigen/Core>

namespace artcal::fitting {

/// Orthogonal triangularisation of a tall matrix [J | r], fed row by row and kept in a fixed space: when
/// the buffer is full its rows are reduced to one triangle (a sequential TSQR; Demmel et al. 2012). As
/// accurate as a QR of the whole matrix, and a million rows take no memory.
template <int Columns>
class RowReducer {
 public:
  using Row = Eigen::Matrix<double, 1, Columns>;
  using Triangle = Eigen::Matrix<double, Columns, Columns>;

  void add(const Row& row) {
    if (filled_ == buffer_.rows()) {
      reduce();
    }
    buffer_.row(filled_++) = row;
  }

  /// The upper triangle R with RᵀR = [J | r]ᵀ[J | r].
  Triangle triangle() {
    reduce();
    return buffer_.template topRows<Columns>();
  }

 private:
  static constexpr int block = 64;

  // Householder, in place on the filled rows; what is left is the triangle.
  void reduce() {
    const int rows = std::max(filled_, Columns);
    buffer_.middleRows(filled_, rows - filled_).setZero();
    for (int c = 0; c < Columns && c + 1 < rows; ++c) {
      auto column = buffer_.col(c).segment(c, rows - c);
      const double norm = column.norm();
      if (norm == 0.0) {
        continue;
      }
      const double diagonal = column(0) > 0.0 ? -norm : norm;
      column(0) -= diagonal;
      const double scale = 1.0 / (diagonal * column(0));
      for (int k = c + 1; k < Columns; ++k) {
        auto other = buffer_.col(k).segment(c, rows - c);
        other += (scale * column.dot(other)) * column;
      }
      column.setZero();
      column(0) = diagonal;
    }
    filled_ = Columns;
  }

  using Buffer = Eigen::Matrix<double, block, Columns>;
  Buffer buffer_ = Buffer::Zero();
  int filled_ = 0;
};

}  // namespace artcal::fitting
