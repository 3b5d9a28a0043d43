#include "identification/least_squares/kernels/normal_triangle.h"

#include <algorithm>
#include <cmath>

#include "identification/least_squares/kernels/gram.h"

namespace artcal {
namespace {

constexpr Eigen::Index rows_of_a_fold = 96;  // as TriangularFactor: few enough for the first cache
constexpr double still_dependent = 1e-14;    // of a column's own square

}  // namespace

NormalTriangle::NormalTriangle(int columns)
    : columns_(columns),
      padded_((columns + 7) / 8 * 8),
      waiting_(std::make_unique_for_overwrite<Line[]>(static_cast<std::size_t>(rows_of_a_fold * padded_ / 8))),
      gram_(static_cast<std::size_t>(padded_ * padded_ / 8)) {}

void NormalTriangle::add(const RowsRef& rows) {
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    double* to = waiting_[0].numbers + filled_ * padded_;
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

// Row by row (Golub, Van Loan 2013, Algorithm 4.2.2 by outer products).
Eigen::MatrixXd NormalTriangle::triangle() {
  fold();
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rest =
      Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(gram_.front().numbers,
                                                                                               padded_, padded_)
          .topLeftCorner(columns_, columns_);
  const Eigen::VectorXd squares = rest.diagonal();
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> triangle =
      decltype(rest)::Zero(columns_, columns_);
  for (Eigen::Index k = 0; k < columns_; ++k) {
    if (!(rest(k, k) > still_dependent * squares[k])) {
      continue;
    }
    const Eigen::Index size = columns_ - k;
    triangle.row(k).tail(size) = rest.row(k).tail(size) / std::sqrt(rest(k, k));
    for (Eigen::Index i = k + 1; i < columns_; ++i) {
      rest.row(i).tail(columns_ - i) -= triangle(k, i) * triangle.row(k).tail(columns_ - i);
    }
  }
  return triangle;
}

}  // namespace artcal
