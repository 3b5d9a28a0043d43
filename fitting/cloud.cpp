#include "fitting/cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "fitting/least_squares/row_reducer.h"
#include "fitting/small_matrix.h"

namespace artcal::fitting {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Expected<void> check(const Points& points, const Eigen::VectorXd& weights) {
  if (const auto bad = first_not_finite(points); bad >= 0) {
    return bad_input(fmt::format("point {} is not finite; every point needs three numbers", bad));
  }
  if (weights.size() == 0) {
    return {};
  }
  if (weights.size() != points.cols()) {
    return bad_input(
        fmt::format("there are {} weights for {} points; give one a point, or none", weights.size(), points.cols()));
  }
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    if (!std::isfinite(weights(i)) || weights(i) < 0.0) {
      return bad_input(fmt::format("the weight of point {} is {}; weights are finite and not negative", i, weights(i)));
    }
  }
  return {};
}

// Copies what has a weight.
void take(const Points& points, const Eigen::VectorXd& weights, Cloud& cloud) {
  if (weights.size() == 0) {
    cloud.points = points;
    return;
  }
  const Eigen::Index used = (weights.array() > 0.0).count();
  cloud.points.resize(3, used);
  cloud.root_weights.resize(used);
  Eigen::Index k = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (weights(i) > 0.0) {
      cloud.points.col(k) = points.col(i);
      cloud.root_weights(k++) = std::sqrt(weights(i));
    }
  }
}

Eigen::Vector3d mean(const Cloud& cloud) {
  if (cloud.root_weights.size() == 0) {
    return cloud.points.rowwise().mean();
  }
  const Eigen::VectorXd weights = cloud.root_weights.array().square();
  return cloud.points * weights / weights.sum();
}

// The second mean takes away what rounding left of the first: an origin far off costs nothing.
void centre(Cloud& cloud) {
  cloud.centroid.setZero();
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::Vector3d shift = mean(cloud);
    cloud.points.colwise() -= shift;
    cloud.centroid += shift;
  }
}

SmallSvd principal(const Cloud& cloud, const Eigen::Matrix3d& onto) {
  RowReducer<3> reducer;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    reducer.add(cloud.root_weight(i) * (onto * cloud.points.col(i)).transpose());
  }
  return small_svd(reducer.triangle());
}

void find_axes(Cloud& cloud) {
  const SmallSvd svd = principal(cloud, Eigen::Matrix3d::Identity());
  cloud.spread = svd.values;
  cloud.axes = svd.right_vectors;
  cloud.axes.col(2) = cloud.axes.col(0).cross(cloud.axes.col(1));
}

std::string_view why_flat(int dimensions) {
  return dimensions == 1 ? "lie on one line; probe points beside it" : "lie in one plane; probe points out of it";
}

}  // namespace

double Cloud::total_weight() const {
  return root_weights.size() == 0 ? static_cast<double>(size()) : root_weights.squaredNorm();
}

void turn_axes(Cloud& cloud, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d n = normal.normalized();
  const SmallSvd across = principal(cloud, Eigen::Matrix3d::Identity() - n * n.transpose());
  Eigen::Vector3d widest = across.right_vectors.col(0);
  widest = (widest - n * n.dot(widest)).normalized();
  cloud.axes << widest, n.cross(widest), n;
  for (int axis = 0; axis < 3; ++axis) {
    cloud.spread(axis) = principal(cloud, cloud.axes.col(axis) * cloud.axes.col(axis).transpose()).values(0);
  }
}

Eigen::Index first_not_finite(const Points& points) {
  constexpr Eigen::Index block_size = 1 << 12;
  for (Eigen::Index begin = 0; begin < points.cols(); begin += block_size) {
    // A number times zero is zero, but for those that are not finite: the sum shows it of a whole block.
    const auto block = points.middleCols(begin, std::min(block_size, points.cols() - begin));
    if (std::isfinite((0.0 * block).sum())) {
      continue;
    }
    for (Eigen::Index i = 0; i < block.cols(); ++i) {
      if (!block.col(i).allFinite()) {
        return begin + i;
      }
    }
  }
  return -1;
}

Expected<Cloud> make_cloud(const Points& points, const Eigen::VectorXd& weights, const Requirement& requirement) {
  if (auto checked = check(points, weights); !checked) {
    return tl::unexpected(checked.error());
  }
  Cloud cloud;
  take(points, weights, cloud);
  if (cloud.size() < requirement.points) {
    return bad_input(fmt::format("a {} needs at least {} points, there are {}{}", requirement.feature,
                                 requirement.points, cloud.size(), weights.size() == 0 ? "" : " of weight above zero"));
  }
  const double reach = cloud.points.cwiseAbs().maxCoeff();
  centre(cloud);
  const double size = std::sqrt(cloud.points.squaredNorm() / static_cast<double>(cloud.size()));
  if (!(size > 4.0 * epsilon * reach)) {
    return bad_input(
        fmt::format("all {} points are the same one; a {} needs different ones", cloud.size(), requirement.feature));
  }
  cloud.scale = size;
  cloud.points /= size;
  cloud.rounding = epsilon * (1.0 + reach / size);
  find_axes(cloud);
  const double flat = 4.0 * cloud.rounding * std::sqrt(cloud.total_weight());
  for (int dimensions = 1; dimensions < requirement.dimensions; ++dimensions) {
    if (cloud.spread(dimensions) <= flat) {
      return no_solution(fmt::format("the points do not determine a {}: all {} {}", requirement.feature, cloud.size(),
                                     why_flat(dimensions)));
    }
  }
  return cloud;
}

}  // namespace artcal::fitting
