#include "identification/least_squares/kernels/normal_triangle.h"

#include <algorithm>

#include "identification/least_squares/kernels/gram.h"

namespace artcal {
namespace {

constexpr Eigen::Index rows_of_a_fold = 96;  // as TriangularFactor: few enough for the first cache

}  // namespace

NormalTriangle::NormalTriangle(int columns)
    : columns_(columns),
      padded_((columns + 7) / 8 * 8),
      waiting_(std::make_unique_for_overwrite<Line[]>(static_cast<std::size_t>(rows_of_a_fold * padded_ / 8))),
      gram_(static_cast<std::size_t>(padded_ * padded_ / 8)) {}

void NormalTriangle::add(const RowsRef& rows) {
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    double* to = waiting_[static_cast<std::size_t>(filled_ * padded_ / 8)].numbers;
    const double* from = rows.row(r);
    if (rows.column_stride() == 1) {
      std::copy_n(from, columns_, to);
    } else {
      for (Eigen::Index c = 0; c < columns_; ++c) {
        to[c] = from[c * rows.column_stride()];
      }
    }
    std::fill(to + columns_, to + padded_, 0.0);
    if (++filled_ == rows_of_a_fold) {
      fold();
    }
  }
}

void NormalTriangle::fold() {
  gram_variants().back().add(waiting_[0].numbers, static_cast<int>(filled_), static_cast<int>(padded_),
                             gram_.front().numbers);
  filled_ = 0;
}

Eigen::MatrixXd NormalTriangle::triangle() {
  fold();
  std::vector<Line> factor = gram_;
  double* numbers = factor.front().numbers;
  gram_factor_variants().back().factor(numbers, static_cast<int>(columns_), static_cast<int>(padded_));
  Eigen::MatrixXd triangle(columns_, columns_);
  for (Eigen::Index c = 0; c < columns_; ++c) {
    for (Eigen::Index r = 0; r < columns_; ++r) {
      triangle(r, c) = r <= c ? numbers[r * padded_ + c] : 0.0;
    }
  }
  return triangle;
}

}  // namespace artcal
