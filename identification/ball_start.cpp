#include "identification/ball_start.h"

#include <cmath>

#include <Eigen/QR>

namespace artcal {
namespace {

constexpr int most_iterations = 50;

// |p − c|² = ρ² less its mean, linear in c: 2 pᵀc + constant = |p|² − ρ²; p from the points' own mean.
std::optional<Eigen::Vector3d> linear_centre(const Eigen::Matrix3Xd& p, const Eigen::VectorXd& rho, double size) {
  Eigen::MatrixXd a(p.cols(), 4);
  a.leftCols<3>() = 2.0 * p.transpose();
  a.col(3).setConstant(size);
  const Eigen::VectorXd b = p.colwise().squaredNorm().transpose() - rho.cwiseAbs2();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
  qr.setThreshold(1e-4);
  if (p.cols() < 4 || qr.rank() < 4) {
    return std::nullopt;
  }
  return Eigen::Vector3d(qr.solve(b).head<3>());
}

// Gauss-Newton on |p − c| = ρ + addend, the addend free or not.
std::optional<Ball> refine(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& rho, bool addend_is_free) {
  const Eigen::Vector3d mean = points.rowwise().mean();
  const Eigen::Matrix3Xd p = points.colwise() - mean;
  const double size = p.norm() / std::sqrt(static_cast<double>(p.cols()));
  const auto start = linear_centre(p, rho, size);
  if (!start) {
    return std::nullopt;
  }
  Ball ball{*start, 0.0};
  const Eigen::Index unknowns = addend_is_free ? 4 : 3;
  Eigen::MatrixXd slope(p.cols(), unknowns);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::Matrix3Xd away = (-p).colwise() + ball.centre;
    const Eigen::VectorXd length = away.colwise().norm();
    if (!(length.minCoeff() > 0.0)) {
      return std::nullopt;
    }
    slope.leftCols<3>() = away.transpose().array().colwise() / length.array();
    slope.rightCols(unknowns - 3).setConstant(-1.0);
    const Eigen::VectorXd step = slope.colPivHouseholderQr().solve(((rho - length).array() + ball.radius).matrix());
    ball.centre += step.head<3>();
    ball.radius += addend_is_free ? step[3] : 0.0;
    if (step.norm() <= 1e-13 * (size + ball.centre.norm())) {
      break;
    }
  }
  return Ball{ball.centre + mean, ball.radius};
}

}  // namespace

std::optional<Eigen::Vector3d> point_at_distances(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& distances) {
  const auto ball = refine(points, distances, false);
  return ball ? std::optional(ball->centre) : std::nullopt;
}

std::optional<Ball> ball_touched_at(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& tip_radii) {
  return refine(points, tip_radii, true);
}

}  // namespace artcal
