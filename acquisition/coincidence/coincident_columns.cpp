#include "acquisition/coincidence/coincident_columns.h"

#include <algorithm>
#include <cmath>

namespace artcal {
namespace {

// A total order, with NaN above all numbers.
int compare(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) {
    return static_cast<int>(std::isnan(a)) - static_cast<int>(std::isnan(b));
  }
  return a < b ? -1 : a > b ? 1 : 0;
}

}  // namespace

std::vector<Eigen::Index> first_coincident(const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  const auto order_of = [&](Eigen::Index i, Eigen::Index j) {
    for (Eigen::Index row = 0; row < columns.rows(); ++row) {
      if (const int order = compare(columns(row, i), columns(row, j)); order != 0) {
        return order;
      }
    }
    return 0;
  };
  // The first row beside the index: most comparisons of a scan's millions of points end there, without a look at the
  // columns, which lie anywhere in memory.
  struct Key {
    double first_row;
    Eigen::Index column;
  };
  std::vector<Key> sorted(static_cast<std::size_t>(columns.cols()));
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    sorted[static_cast<std::size_t>(i)] = {columns.rows() > 0 ? columns(0, i) : 0.0, i};
  }
  std::sort(sorted.begin(), sorted.end(), [&](const Key& a, const Key& b) {
    int order = compare(a.first_row, b.first_row);
    order = order == 0 ? order_of(a.column, b.column) : order;
    return order < 0 || (order == 0 && a.column < b.column);
  });
  std::vector<Eigen::Index> first(sorted.size());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const Eigen::Index column = sorted[k].column;
    const bool repeats = k > 0 && order_of(sorted[k - 1].column, column) == 0;
    first[static_cast<std::size_t>(column)] = repeats ? first[static_cast<std::size_t>(sorted[k - 1].column)] : column;
  }
  return first;
}

}  // namespace artcal
