#include "identification/triangular_factor.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

namespace artcal {
namespace {

// Rows that wait before they are folded: enough to make the reflections long, few enough for the first
// cache. Folding below the triangle, reflection by reflection, takes half the time of a general QR of the
// two stacked (docs/benchmarks.md).
constexpr Eigen::Index block_rows = 96;

}  // namespace

TriangularFactor::TriangularFactor(int columns)
    : triangle_(Eigen::MatrixXd::Zero(columns, columns)), waiting_(block_rows, columns) {}

void TriangularFactor::add(const double* row_major, int rows) {
  using Rows = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  const Rows block(row_major, rows, waiting_.cols());
  for (Eigen::Index done = 0; done < rows;) {
    const Eigen::Index take = std::min<Eigen::Index>(rows - done, block_rows - filled_);
    waiting_.middleRows(filled_, take) = block.middleRows(done, take);
    filled_ += take;
    done += take;
    if (filled_ == block_rows) {
      fold();
    }
  }
}

void TriangularFactor::add(const Eigen::Ref<const Eigen::MatrixXd>& rows) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> copy = rows;
  add(copy.data(), static_cast<int>(copy.rows()));
}

// One reflection a column: it takes the waiting rows' column to zero and touches of the triangle the
// column's own row only (Golub, Van Loan 2013, Algorithm 5.1.1 with the vector's first element 1).
void TriangularFactor::fold() {
  const Eigen::Index columns = triangle_.cols();
  auto rows = waiting_.topRows(filled_);
  for (Eigen::Index k = 0; k < columns; ++k) {
    auto v = rows.col(k);
    const double below = v.squaredNorm();
    if (below == 0.0) {
      continue;
    }
    const double head = triangle_(k, k);
    const double length = std::sqrt(head * head + below);
    const double first = head <= 0.0 ? head - length : -below / (head + length);
    const double twice = 2.0 * first * first / (below + first * first);
    triangle_(k, k) = length;
    v /= first;
    for (Eigen::Index j = k + 1; j < columns; ++j) {
      auto column = rows.col(j);
      const double along = twice * (v.dot(column) + triangle_(k, j));
      triangle_(k, j) -= along;
      column -= along * v;
    }
  }
  filled_ = 0;
}

Eigen::MatrixXd TriangularFactor::triangle() {
  if (filled_ > 0) {
    fold();
  }
  return triangle_;
}

Eigen::MatrixXd eliminate_leading(const Eigen::MatrixXd& triangle, int nuisance_columns) {
  if (nuisance_columns == 0) {
    return triangle;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(triangle.leftCols(nuisance_columns));
  qr.setThreshold(1e-12);
  Eigen::MatrixXd rest = triangle.rightCols(triangle.cols() - nuisance_columns);
  rest.applyOnTheLeft(qr.householderQ().transpose());
  return rest.bottomRows(rest.rows() - qr.rank());
}

}  // namespace artcal
