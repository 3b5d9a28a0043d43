#include "acquisition/coincident_columns.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  std::vector<Eigen::Index> sorted(static_cast<std::size_t>(columns.cols()));
  std::iota(sorted.begin(), sorted.end(), Eigen::Index{0});
  std::sort(sorted.begin(), sorted.end(), [&](Eigen::Index i, Eigen::Index j) {
    const int order = order_of(i, j);
    return order < 0 || (order == 0 && i < j);
  });
  std::vector<Eigen::Index> first(sorted.size());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const auto i = static_cast<std::size_t>(sorted[k]);
    const bool repeats = k > 0 && order_of(sorted[k - 1], sorted[k]) == 0;
    first[i] = repeats ? first[static_cast<std::size_t>(sorted[k - 1])] : sorted[k];
  }
  return first;
}

}  // namespace artcal
