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
      waiting_(static_cast<std::size_t>(groups_ * pairs_at_once)) {}

void TriangularFactor::add(const RowsRef& rows) {
  for (Eigen::Index done = 0; done < rows.rows();) {
    const Eigen::Index take = std::min<Eigen::Index>(rows.rows() - done, rows_at_once - filled_);
    for (Eigen::Index r = 0; r < take; ++r) {
      const double* row = rows.data() + (done + r) * rows.innerStride();
      double* at = waiting_[(filled_ + r) / 2].values + (filled_ + r) % 2;
      for (Eigen::Index first = 0; first < columns_; first += group_size, at += 2 * group_size * pairs_at_once) {
        for (Eigen::Index c = 0; c < std::min(group_size, columns_ - first); ++c) {
          at[2 * c] = row[(first + c) * rows.outerStride()];
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
// that stand in its group are not looked at any more.
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
  const Eigen::Index pairs = filled_ / 2;
  std::array<RowPairs, pairs_at_once> reflector;
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, rows_at_once, 1> v(filled_);
  for (Eigen::Index k = 0; k < columns_; ++k) {
    const RowPairs* own = waiting_.data() + k / group_size * pairs_at_once;
    const Eigen::Index at = 2 * (k % group_size);
    for (Eigen::Index p = 0; p < pairs; ++p) {
      v.segment<2>(2 * p) = Eigen::Vector2d::MapAligned(own[p].values + at);
    }
    const double below = v.squaredNorm();
    if (below == 0.0) {
      continue;
    }
    const double head = triangle_(k, k);
    const double length = std::sqrt(head * head + below);
    const double first = head <= 0.0 ? head - length : -below / (head + length);
    const double twice = 2.0 * first * first / (below + first * first);
    v /= first;
    for (Eigen::Index p = 0; p < pairs; ++p) {
      const Eigen::Vector2d pair = v.segment<2>(2 * p);
      for (Eigen::Index c = 0; c < group_size; ++c) {
        Eigen::Vector2d::MapAligned(reflector[p].values + 2 * c) = pair;
      }
    }
    const Eigen::Index group = (k + 1) / group_size;
    reflect(reflector.data(), static_cast<int>(pairs), twice, triangle_.row(k).data() + group_size * group,
            waiting_.data() + group * pairs_at_once, pairs_at_once, static_cast<int>(groups_ - group));
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
