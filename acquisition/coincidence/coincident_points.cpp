#include "acquisition/coincidence/coincident_points.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/coincidence/coincident_columns.h"

namespace artcal {
namespace {

bool is_zero(const Eigen::Matrix3Xd& points, Eigen::Index i) {
  return points(0, i) == 0.0 && points(1, i) == 0.0 && points(2, i) == 0.0;
}

std::vector<bool> points_at_zero(const Eigen::Matrix3Xd& points) {
  std::vector<bool> at_zero(static_cast<std::size_t>(points.cols()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    at_zero[static_cast<std::size_t>(i)] = is_zero(points, i);
  }
  return at_zero;
}

// Whether the origin lies farther off the bounding box of the others than its diagonal.
bool origin_is_apart(const Eigen::Matrix3Xd& points, const std::vector<bool>& at_zero) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (!at_zero[static_cast<std::size_t>(i)]) {
      low = low.cwiseMin(points.col(i));
      high = high.cwiseMax(points.col(i));
    }
  }
  const Eigen::Vector3d off = low.cwiseMax(-high).cwiseMax(0.0);
  return off.norm() > (high - low).norm();
}

void keep(PointCloud& cloud, const std::vector<bool>& dropped) {
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < cloud.points.cols(); ++i) {
    if (dropped[static_cast<std::size_t>(i)]) {
      continue;
    }
    cloud.points.col(kept) = cloud.points.col(i).eval();
    if (cloud.joints.rows() > 0) {
      cloud.joints.col(kept) = cloud.joints.col(i).eval();
    }
    cloud.rows[static_cast<std::size_t>(kept)] = cloud.rows[static_cast<std::size_t>(i)];
    ++kept;
  }
  cloud.points.conservativeResize(3, kept);
  cloud.joints.conservativeResize(cloud.joints.rows(), cloud.joints.rows() == 0 ? 0 : kept);
  cloud.rows.resize(static_cast<std::size_t>(kept));
}

std::vector<RepeatedColumn> repeated_points(const PointCloud& cloud) {
  if (cloud.joints.rows() == 0) {
    return repeated_columns(cloud.points);
  }
  Eigen::MatrixXd columns(3 + cloud.joints.rows(), cloud.points.cols());
  columns << cloud.points, cloud.joints;
  return repeated_columns(columns);
}

void drop_zeros(PointCloud& cloud) {
  Eigen::Index zeros = 0;
  for (Eigen::Index i = 0; i < cloud.points.cols(); ++i) {
    zeros += is_zero(cloud.points, i) ? 1 : 0;
  }
  if (zeros == 0) {
    return;
  }
  const auto at_zero = points_at_zero(cloud.points);
  if (zeros == cloud.points.cols() || (zeros == 1 && !origin_is_apart(cloud.points, at_zero))) {
    return;
  }
  cloud.warnings.push_back(fmt::format(
      "{} of {} points {} at exactly 0 0 0, which instruments write where they measured nothing; {} left out", zeros,
      cloud.points.cols(), zeros == 1 ? "is" : "are", zeros == 1 ? "it was" : "they were"));
  keep(cloud, at_zero);
}

}  // namespace

std::size_t merge_equal_points(PointCloud& cloud) {
  const auto repeated = repeated_points(cloud);
  if (!repeated.empty()) {
    std::vector<bool> dropped(static_cast<std::size_t>(cloud.points.cols()), false);
    for (const RepeatedColumn& one : repeated) {
      dropped[static_cast<std::size_t>(one.column)] = true;
    }
    keep(cloud, dropped);
  }
  return repeated.size();
}

void drop_coincident_points(PointCloud& cloud) {
  drop_zeros(cloud);
  const Eigen::Index points = cloud.points.cols();
  if (const std::size_t count = merge_equal_points(cloud); count > 0) {
    cloud.warnings.push_back(
        fmt::format("{} of {} points repeat an earlier one in every digit; each place is counted once", count, points));
  }
}

}  // namespace artcal
