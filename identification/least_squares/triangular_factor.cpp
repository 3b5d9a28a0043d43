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
constexpr Eigen::Index pairs_at_once = rows_at_once / 2;
constexpr Eigen::Index group_size = 4;  // columns, see RowPairs

}  // namespace

TriangularFactor::TriangularFactor(int columns)
    : columns_(columns),
      groups_((columns + group_size - 1) / group_size),
      triangle_(decltype(triangle_)::Zero(columns, group_size * groups_)),
      waiting_(std::make_unique_for_overwrite<RowPairs[]>(static_cast<std::size_t>(groups_ * pairs_at_once))) {}

void TriangularFactor::add(const RowsRef& rows) {
  for (Eigen::Index done = 0; done < rows.rows();) {
    const Eigen::Index take = std::min<Eigen::Index>(rows.rows() - done, rows_at_once - filled_);
    for (Eigen::Index r = 0; r < take; ++r) {
      const double* row = rows.row(done + r);
      double* at = waiting_[(filled_ + r) / 2].values + (filled_ + r) % 2;
      for (Eigen::Index first = 0; first < columns_; first += group_size, at += 2 * group_size * pairs_at_once) {
        for (Eigen::Index c = 0; c < group_size; ++c) {
          at[2 * c] = first + c < columns_ ? row[(first + c) * rows.column_stride()] : 0.0;
        }
      }
    }
    filled_ += take;
    done += take;
    if (filled_ == rows_at_once) {
      fold();
    }
  }
}

// One reflection a column: it takes the waiting rows' column to zero and touches of the triangle the
// column's own row only (Golub, Van Loan 2013, Algorithm 5.1.1 with the vector's first element 1). Columns before it
// that stand in its group are not looked at any more. Rows before the first and after the last in which the column is
// not zero (other features' readings, the zeros below a triangle) are as they were afterwards, and left out.
void TriangularFactor::fold() {
  Reflection* reflect = reflection_variants().back().reflect;
  if (filled_ % 2 == 1) {  // rows_at_once is even
    for (Eigen::Index g = 0; g < groups_; ++g) {
      for (Eigen::Index c = 0; c < group_size; ++c) {
        waiting_[g * pairs_at_once + filled_ / 2].values[2 * c + 1] = 0.0;
      }
    }
    ++filled_;
  }
  std::array<RowPairs, pairs_at_once> reflector;
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, rows_at_once, 1> v(filled_);
  for (Eigen::Index k = 0; k < columns_; ++k) {
    const RowPairs* own = waiting_.get() + k / group_size * pairs_at_once;
    const Eigen::Index at = 2 * (k % group_size);
    const auto is_zero = [&](Eigen::Index p) { return own[p].values[at] == 0.0 && own[p].values[at + 1] == 0.0; };
    Eigen::Index begin = 0;
    Eigen::Index end = filled_ / 2;
    while (begin < end && is_zero(begin)) {
      ++begin;
    }
    while (begin < end && is_zero(end - 1)) {
      --end;
    }
    if (begin == end) {
      continue;
    }
    v.head(2 * begin).setZero();
    for (Eigen::Index p = begin; p < end; ++p) {
      v.segment<2>(2 * p) = Eigen::Vector2d::MapAligned(own[p].values + at);
    }
    v.tail(filled_ - 2 * end).setZero();
    const double below = v.squaredNorm();  // of all: zeros have a place in the order in which Eigen sums
    if (below == 0.0) {
      continue;
    }
    const double head = triangle_(k, k);
    const double length = std::sqrt(head * head + below);
    const double first = head <= 0.0 ? head - length : -below / (head + length);
    const double twice = 2.0 * first * first / (below + first * first);
    for (Eigen::Index p = begin; p < end; ++p) {
      const Eigen::Vector2d pair = v.segment<2>(2 * p) / first;
      for (Eigen::Index c = 0; c < group_size; ++c) {
        Eigen::Vector2d::MapAligned(reflector[p].values + 2 * c) = pair;
      }
    }
    const Eigen::Index group = (k + 1) / group_size;
    reflect(reflector.data() + begin, static_cast<int>(end - begin), twice,
            triangle_.row(k).data() + group_size * group, waiting_.get() + group * pairs_at_once + begin, pairs_at_once,
            static_cast<int>(groups_ - group));
    for (Eigen::Index c = group_size * group; c < k; ++c) {
      triangle_(k, c) = 0.0;
    }
    triangle_(k, k) = length;
  }
  filled_ = 0;
}

Eigen::MatrixXd TriangularFactor::triangle() {
  if (filled_ > 0) {
    fold();
  }
  return triangle_.leftCols(columns_);
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
