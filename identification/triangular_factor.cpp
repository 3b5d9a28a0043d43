#include "identification/triangular_factor.h"

#include <algorithm>

#include <Eigen/QR>

namespace artcal {
namespace {

// Rows that wait before they are folded: enough to make the reflections long, few enough for the cache.
constexpr Eigen::Index block_rows = 192;

}  // namespace

TriangularFactor::TriangularFactor(int columns) : stack_(Eigen::MatrixXd::Zero(columns + block_rows, columns)) {}

void TriangularFactor::add(const double* row_major, int rows) {
  using Rows = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  const Rows block(row_major, rows, stack_.cols());
  for (Eigen::Index done = 0; done < rows;) {
    const Eigen::Index take = std::min<Eigen::Index>(rows - done, block_rows - filled_);
    stack_.middleRows(stack_.cols() + filled_, take) = block.middleRows(done, take);
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

void TriangularFactor::fold() {
  const Eigen::Index columns = stack_.cols();
  auto used = stack_.topRows(columns + filled_);
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(used);
  stack_.topRows(columns).triangularView<Eigen::StrictlyLower>().setZero();
  stack_.bottomRows(block_rows).setZero();
  filled_ = 0;
}

Eigen::MatrixXd TriangularFactor::triangle() {
  if (filled_ > 0) {
    fold();
  }
  return stack_.topRows(stack_.cols());
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
