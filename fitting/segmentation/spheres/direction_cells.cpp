#include "fitting/segmentation/spheres/direction_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace artcal::segmentation {
namespace {

using std::numbers::pi;

// Solid angle of the rectangle [0, x] × [0, y] on the plane z = 1.
double corner(double x, double y) { return std::atan2(x * y, std::sqrt(1.0 + x * x + y * y)); }

}  // namespace

DirectionCells::DirectionCells(int per_edge) : per_edge_(per_edge) {
  const auto border = [&](int i) { return std::tan(pi / 4.0 * (2.0 * i / per_edge - 1.0)); };
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < per_edge; ++i) {
      for (int j = 0; j < per_edge; ++j) {
        const double x0 = border(i), x1 = border(i + 1), y0 = border(j), y1 = border(j + 1);
        shares_.push_back((corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0)) / (4.0 * pi));
      }
    }
  }
}

std::size_t DirectionCells::cell_of(const Eigen::Vector3d& direction) const {
  Eigen::Index axis = 0;
  const double largest = direction.cwiseAbs().maxCoeff(&axis);
  const auto step = [&](double value) {
    const int i = static_cast<int>((std::atan(value / largest) * (4.0 / pi) + 1.0) * 0.5 * per_edge_);
    return static_cast<std::size_t>(std::clamp(i, 0, per_edge_ - 1));
  };
  const std::size_t face = 2 * static_cast<std::size_t>(axis) + (direction(axis) < 0.0 ? 1 : 0);
  const auto n = static_cast<std::size_t>(per_edge_);
  return (face * n + step(direction((axis + 1) % 3))) * n + step(direction((axis + 2) % 3));
}

}  // namespace artcal::segmentation
