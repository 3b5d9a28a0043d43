#include "fitting/bounding_box.h"

#include <cassert>
#include <vector>

#include "core/parallel.h"

namespace artcal::fitting {

BoundingBox bounding_box(const Points& points) {
  assert(points.cols() > 0);
  constexpr std::size_t block_size = std::size_t{1} << 16u;
  const auto count = static_cast<std::size_t>(points.cols());
  std::vector<BoundingBox> boxes((count + block_size - 1) / block_size, {points.col(0), points.col(0)});
  parallel_blocks(count, block_size, [&](std::size_t begin, std::size_t end) {
    BoundingBox box = boxes[begin / block_size];
    for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i) {
      box.low = box.low.cwiseMin(points.col(i));
      box.high = box.high.cwiseMax(points.col(i));
    }
    boxes[begin / block_size] = box;
  });
  BoundingBox all = boxes.front();
  for (const BoundingBox& box : boxes) {
    all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
  }
  return all;
}

}  // namespace artcal::fitting
