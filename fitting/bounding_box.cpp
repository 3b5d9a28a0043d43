#include "fitting/bounding_box.h"

#include <cassert>
#include <vector>

#include "fitting/point_blocks.h"

namespace artcal::fitting {

BoundingBox bounding_box(const Points& points) {
  assert(points.cols() > 0);
  const auto count = static_cast<std::size_t>(points.cols());
  const auto boxes = of_each_block<BoundingBox>(count, [&](std::size_t begin, std::size_t end) {
    BoundingBox box{points.col(0), points.col(0)};
    for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i) {
      box.low = box.low.cwiseMin(points.col(i));
      box.high = box.high.cwiseMax(points.col(i));
    }
    return box;
  });
  BoundingBox all = boxes.front();
  for (const BoundingBox& box : boxes) {
    all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
  }
  return all;
}

}  // namespace artcal::fitting
