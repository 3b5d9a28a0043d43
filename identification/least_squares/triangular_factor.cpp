#include "identification/least_squares/triangular_factor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/QR>

namespace artcal {
namespace {

// Rows that wait before they are folded: enough to make the reflections long, few enough for the first
// cache. Folding below the triangle, reflection by reflection, takes half the time of a general QR of the
// two stacked (docs/benchmarks.md).
constexpr Eigen::Index rows_at_once = 96;

// Columns that are reflected at once: each pair of the reflector's numbers is loaded once for all of them, and their
// sums do not wait for one another.
constexpr int together = 4;

// Reflects `width` columns, each the triangle's element over the waiting rows, whose number is even.
template <int width, typename Vector, typename Row, typename Columns>
void reflect(const Vector& v, double twice, Row&& row, Columns&& columns) {
  std::array<Eigen::Array2d, width> sums;
  sums.fill(Eigen::Array2d::Zero());
  for (Eigen::Index r = 0; r < v.size(); r += 2) {
    const Eigen::Array2d pair = v.template segment<2>(r).array();
    for (int c = 0; c < width; ++c) {
      sums[c] += pair * columns.col(c).template segment<2>(r).array();
    }
  }
  std::array<double, width> along;
  for (int c = 0; c < width; ++c) {
    along[c] = twice * (sums[c].sum() + row[c]);
    row[c] -= along[c];
  }
  for (Eigen::Index r = 0; r < v.size(); r += 2) {
    const Eigen::Array2d pair = v.template segment<2>(r).array();
    for (int c = 0; c < width; ++c) {
      columns.col(c).template segment<2>(r).array() -= along[c] * pair;
    }
  }
}

}  // namespace

TriangularFactor::TriangularFactor(int columns)
    : triangle_(Eigen::MatrixXd::Zero(columns, columns)), waiting_(rows_at_once, columns) {}

void TriangularFactor::add(const RowsRef& rows) {
  for (Eigen::Index done = 0; done < rows.rows();) {
    const Eigen::Index take = std::min<Eigen::Index>(rows.rows() - done, rows_at_once - filled_);
    waiting_.middleRows(filled_, take) = rows.middleRows(done, take);
    filled_ += take;
    done += take;
    if (filled_ == rows_at_once) {
      fold();
    }
  }
}

// One reflection a column: it takes the waiting rows' column to zero and touches of the triangle the
// column's own row only (Golub, Van Loan 2013, Algorithm 5.1.1 with the vector's first element 1).
void TriangularFactor::fold() {
  const Eigen::Index columns = triangle_.cols();
  if (filled_ % 2 == 1) {
    waiting_.row(filled_++).setZero();  // rows_at_once is even
  }
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
    Eigen::Index j = k + 1;
    for (; j + together <= columns; j += together) {
      reflect<together>(v, twice, triangle_.row(k).segment<together>(j), rows.middleCols<together>(j));
    }
    for (; j < columns; ++j) {
      reflect<1>(v, twice, triangle_.row(k).segment<1>(j), rows.middleCols<1>(j));
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

Eigen::MatrixXd eliminate_leading(const Eigen::MatrixXd& rows, int nuisance_columns) {
  if (nuisance_columns == 0) {
    return rows;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows.leftCols(nuisance_columns));
  qr.setThreshold(1e-12);
  Eigen::MatrixXd rest = rows.rightCols(rows.cols() - nuisance_columns);
  rest.applyOnTheLeft(qr.householderQ().transpose());
  return rest.bottomRows(rest.rows() - qr.rank());
}

}  // namespace artcal
