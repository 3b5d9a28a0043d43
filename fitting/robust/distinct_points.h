#pragma once

#include <vector>

#include "fitting/fit.h"

namespace artcal::fitting {

/// Points that differ, and which of them each point is: one touch read many times is no evidence for itself. Where all
/// differ and have a weight, they are the points given and not copied, which must outlive this.
class DistinctPoints {
 public:
  /// `weights` of the points, or none.
  DistinctPoints(const Points& points, const Eigen::VectorXd& weights);
  DistinctPoints(const DistinctPoints&) = delete;
  DistinctPoints& operator=(const DistinctPoints&) = delete;

  [[nodiscard]] const Points& points() const { return points_; }
  [[nodiscard]] const Eigen::VectorXd& weights() const { return weights_; }  ///< of each, or none
  /// Which of them a point given is, -1 where its weight is zero.
  [[nodiscard]] int of(std::size_t point) const { return of_.empty() ? static_cast<int>(point) : of_[point]; }

 private:
  std::vector<int> of_;  // none where the points are those given
  Eigen::Matrix3Xd copied_;
  Points points_;
  Eigen::VectorXd weights_;
};

}  // namespace artcal::fitting
