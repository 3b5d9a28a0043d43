#include "artefacts/verification/sphere_plate/ball_outliers.h"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "artefacts/verification/sphere_plate/rigid_fit.h"
#include "core/statistics.h"

namespace artcal {
namespace {

constexpr double chance_of_one_set = 0.01;
constexpr Eigen::Index enough_for_directions = 9;
constexpr double least_scatter = 1e-9;  // mm

Eigen::Matrix3Xd without(const Eigen::Matrix3Xd& points, Eigen::Index i) {
  Eigen::Matrix3Xd rest(3, points.cols() - 1);
  rest << points.leftCols(i), points.rightCols(points.cols() - 1 - i);
  return rest;
}

// I − H of a point, H its leverage in the pose of all; what the pose of the others foretells of it is uncertain by
// the inverse, in units of a coordinate's variance. `arms` are the turned certified points from their centroid.
Eigen::Matrix3d certainty_of(const Eigen::Matrix3Xd& arms, Eigen::Index i) {
  const Eigen::Matrix3d inertia = arms.squaredNorm() * Eigen::Matrix3d::Identity() - arms * arms.transpose();
  const Eigen::Vector3d p = arms.col(i);
  Eigen::Matrix3d lever;
  lever << 0.0, p.z(), -p.y(), -p.z(), 0.0, p.x(), p.y(), -p.x(), 0.0;
  return Eigen::Matrix3d::Identity() * (1.0 - 1.0 / static_cast<double>(arms.cols())) -
         lever * inertia.inverse() * lever.transpose();
}

}  // namespace

BallOutlierTest studentised_residuals(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& certified) {
  const Eigen::Index n = measured.cols();
  BallOutlierTest result{Eigen::VectorXd::Zero(n), 0.0};
  const auto freedom = static_cast<double>(3 * (n - 1) - 6);
  const auto whole = fit_rigid(measured, certified);
  if (!whole || freedom < 1.0) {
    return result;
  }
  const bool by_direction = n >= enough_for_directions;
  const double axis_freedom = freedom / 3.0;
  const double chance = chance_of_one_set / static_cast<double>(n);
  // Hotelling: T²·(ν − 2)/(3ν) is F with (3, ν − 2); one scatter for all: T²/3 is F with (3, freedom).
  result.limit =
      by_direction
          ? std::sqrt(3.0 * axis_freedom / (axis_freedom - 2.0) * f_quantile_above(chance, 3.0, axis_freedom - 2.0))
          : std::sqrt(3.0 * f_quantile_above(chance, 3.0, freedom));
  const Eigen::Matrix3Xd arms = whole->to_from.rotation * (certified.colwise() - certified.rowwise().mean());
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto rest = fit_rigid(without(measured, i), without(certified, i));
    if (!rest) {
      continue;
    }
    Eigen::Matrix3d scatter = rest->residuals * rest->residuals.transpose() / axis_freedom;
    if (!by_direction) {
      scatter = scatter.trace() / 3.0 * Eigen::Matrix3d::Identity();
    }
    scatter += least_scatter * least_scatter * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d off = measured.col(i) - rest->to_from * Eigen::Vector3d(certified.col(i));
    const Eigen::Matrix3d root = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(certainty_of(arms, i)).operatorSqrt();
    const Eigen::Vector3d fair = root * off;
    result.distances(i) = std::sqrt(fair.dot(scatter.inverse() * fair));
  }
  return result;
}

}  // namespace artcal
