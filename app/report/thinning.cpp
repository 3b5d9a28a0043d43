#include "app/report/thinning.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace artcal {

std::vector<int> thinned(const std::vector<double>& x, const std::vector<double>& y, int most) {
  assert(x.size() == y.size() && most >= 8);
  std::vector<int> order;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i])) {
      order.push_back(static_cast<int>(i));
    }
  }
  const auto count = static_cast<std::ptrdiff_t>(order.size());
  if (count <= most) {
    return order;
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return x[a] < x[b]; });
  const std::ptrdiff_t stretches = most / 4;  // four points of each: the extremes, and two between
  std::vector<int> kept;
  for (std::ptrdiff_t stretch = 0; stretch < stretches; ++stretch) {
    const auto begin = order.begin() + count * stretch / stretches;
    const auto end = order.begin() + count * (stretch + 1) / stretches;
    const auto [lowest, highest] = std::minmax_element(begin, end, [&](int a, int b) { return y[a] < y[b]; });
    const auto size = std::distance(begin, end);
    kept.insert(kept.end(), {*lowest, *highest, begin[size / 3], begin[2 * size / 3]});
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace artcal
