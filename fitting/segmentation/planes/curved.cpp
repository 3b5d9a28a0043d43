#include "fitting/segmentation/planes/curved.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace artcal::segmentation {

bool is_curved(const Eigen::Matrix3Xd& points, const Plane& plane) {
  constexpr int flat_terms = 3;
  constexpr int terms = 6;
  constexpr double beyond_chance = 8.0;  // F with 3 degrees of freedom: one in thousands, also with few points
  constexpr double max_of_extent = 3e-3;
  const Eigen::Index count = points.cols();
  if (count <= terms) {
    return false;
  }
  const Eigen::Matrix3Xd from_point = points.colwise() - plane.point;
  const Eigen::Vector3d first = plane.normal.unitOrthogonal();
  Eigen::Matrix2Xd across(2, count);
  across.row(0) = first.transpose() * from_point;
  across.row(1) = plane.normal.cross(first).transpose() * from_point;
  const Eigen::Matrix2d spread = across * across.transpose() / static_cast<double>(count);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> extents(spread);
  const double extent = std::sqrt(std::max(0.0, extents.eigenvalues()(0)));
  across = extents.eigenvectors().transpose() * across;
  Eigen::MatrixXd rows(count, terms);
  rows.col(0).setOnes();
  for (int axis = 0; axis < 2; ++axis) {
    const double size = std::sqrt(std::max(extents.eigenvalues()(axis), 1e-300));
    rows.col(1 + axis) = across.row(axis).transpose() / size;
  }
  rows.col(3) = rows.col(1).array().square();
  rows.col(4) = rows.col(1).array() * rows.col(2).array();
  rows.col(5) = rows.col(2).array().square();
  const Eigen::VectorXd heights = (plane.normal.transpose() * from_point).transpose();
  const auto squares_left = [&](int some) {
    const Eigen::MatrixXd used = rows.leftCols(some);
    return (heights - used * used.colPivHouseholderQr().solve(heights)).squaredNorm();
  };
  const double left = squares_left(terms);
  const double part = squares_left(flat_terms) - left;
  const double variance = left / static_cast<double>(count - terms);
  return part > beyond_chance * (terms - flat_terms) * variance &&
         std::sqrt(part / static_cast<double>(count)) > max_of_extent * extent;
}

}  // namespace artcal::segmentation
