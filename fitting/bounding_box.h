#pragma once

#include "fitting/fit.h"

namespace artcal::fitting {

/// Least and largest coordinates of points. REQUIRES one point at least, all finite.
struct BoundingBox {
  Eigen::Vector3d low, high;

  [[nodiscard]] Eigen::Vector3d size() const { return high - low; }
  [[nodiscard]] double largest_coordinate() const { return low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff(); }
};

BoundingBox bounding_box(const Points& points);

}  // namespace artcal::fitting
