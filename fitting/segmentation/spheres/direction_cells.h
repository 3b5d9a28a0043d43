#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace artcal::segmentation {

/// The unit sphere cut into 6·n² cells: a cube's faces, n by n, in equal angles.
class DirectionCells {
 public:
  explicit DirectionCells(int per_edge);  ///< REQUIRES per_edge ≥ 1

  [[nodiscard]] std::size_t size() const { return shares_.size(); }
  [[nodiscard]] std::size_t cell_of(const Eigen::Vector3d& direction) const;  ///< of any length but 0
  /// The cell's part of the whole sphere; all of them add up to 1.
  [[nodiscard]] double share(std::size_t cell) const { return shares_[cell]; }

 private:
  int per_edge_;
  std::vector<double> shares_;
};

}  // namespace artcal::segmentation
