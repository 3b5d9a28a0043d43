#include "artefacts/constraints/point_line.h"

#include <algorithm>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace artcal {
namespace {

// A right-handed frame with z along the direction; the same direction gives the same frame.
Eigen::Matrix3d frame_along(Eigen::Vector3d direction) {
  Eigen::Index largest = 0;
  Eigen::Index smallest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  direction.cwiseAbs().minCoeff(&smallest);
  direction *= direction[largest] < 0.0 ? -1.0 : 1.0;
  Eigen::Matrix3d frame;
  frame.col(0) = direction.cross(Eigen::Vector3d::Unit(smallest)).normalized();
  frame.col(1) = direction.cross(frame.col(0));
  frame.col(2) = direction;
  return frame;
}

}  // namespace

PointLine line_through(const std::vector<Eigen::Vector3d>& points) {
  PointLine line;
  for (const auto& point : points) {
    line.middle += point / static_cast<double>(points.size());
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& point : points) {
    scatter += (point - line.middle) * (point - line.middle).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(scatter);
  line.artefact_from_line = frame_along(eigen.eigenvectors().col(2).normalized());
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  for (const auto& point : points) {
    const Eigen::Vector3d in_line = line.artefact_from_line.transpose() * (point - line.middle);
    line.straightness = std::max(line.straightness, in_line.head<2>().norm());
    first = std::min(first, in_line.z());
    last = std::max(last, in_line.z());
  }
  line.length = last - first;
  return line;
}

}  // namespace artcal
