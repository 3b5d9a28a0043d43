#include "identification/ball_start.h"

#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
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

struct Fitted {
  Ball ball;
  double squares = 0.0;
};

// Gauss-Newton on |p − c| = ρ by normal equations: directions that span space are well enough conditioned for them,
// and a step's own rounding is gone with the next. This is where an identification without a start spends its time.
std::optional<Fitted> refine_centre(const Eigen::Matrix3Xd& p, const Eigen::VectorXd& rho, double size,
                                    Eigen::Vector3d centre) {
  double squares = 0.0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    squares = 0.0;
    for (Eigen::Index i = 0; i < p.cols(); ++i) {
      const Eigen::Vector3d away = centre - p.col(i);
      const double length = away.norm();
      if (!(length > 0.0)) {
        return std::nullopt;
      }
      const Eigen::Vector3d outwards = away / length;
      const double miss = rho[i] - length;
      normal.noalias() += outwards * outwards.transpose();
      gradient += miss * outwards;
      squares += miss * miss;
    }
    const Eigen::Vector3d step = normal.ldlt().solve(gradient);
    centre += step;
    if (step.norm() <= 1e-13 * (size + centre.norm())) {
      break;
    }
  }
  return Fitted{{centre, 0.0}, squares};
}

// The same with an addend to all ρ that is found as well. A cap tells it and the centre badly apart: QR.
std::optional<Fitted> refine_ball(const Eigen::Matrix3Xd& p, const Eigen::VectorXd& rho, double size, Ball ball) {
  Eigen::MatrixX4d slope(p.cols(), 4);
  slope.col(3).setConstant(-1.0);
  Eigen::VectorXd miss;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::Matrix3Xd away = (-p).colwise() + ball.centre;
    const Eigen::VectorXd length = away.colwise().norm();
    if (!(length.minCoeff() > 0.0)) {
      return std::nullopt;
    }
    slope.leftCols<3>() = away.transpose().array().colwise() / length.array();
    miss = (rho - length).array() + ball.radius;
    const Eigen::Vector4d step = slope.colPivHouseholderQr().solve(miss);
    ball.centre += step.head<3>();
    ball.radius += step[3];
    if (step.norm() <= 1e-13 * (size + ball.centre.norm())) {
      break;
    }
  }
  return Fitted{ball, miss.squaredNorm()};
}

// The best of the fits begun at the linear centre and, because readings on half a ball that scatter by a good
// part of its radius fit one on the wrong side of them as well, on either side of the readings.
std::optional<Ball> best_fit(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& rho, bool addend_is_free) {
  const Eigen::Vector3d mean = points.rowwise().mean();
  const Eigen::Matrix3Xd p = points.colwise() - mean;
  const double size = p.norm() / std::sqrt(static_cast<double>(p.cols()));
  const auto start = linear_centre(p, rho, size);
  if (!start) {
    return std::nullopt;
  }
  std::vector<Eigen::Vector3d> starts{*start};
  if (!addend_is_free) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(p * p.transpose());
    const Eigen::Vector3d aside = 0.5 * rho.mean() * eigen.eigenvectors().col(0);
    starts.insert(starts.end(), {aside, -aside});
  }
  std::optional<Fitted> best;
  for (const Eigen::Vector3d& centre : starts) {
    const auto fit = addend_is_free ? refine_ball(p, rho, size, {centre, 0.0}) : refine_centre(p, rho, size, centre);
    // The first stays unless another is clearly better, so that the digits do not depend on rounding.
    if (fit && (!best || fit->squares < (1.0 - 1e-6) * best->squares)) {
      best = fit;
    }
  }
  return best ? std::optional(Ball{best->ball.centre + mean, best->ball.radius}) : std::nullopt;
}

}  // namespace

std::optional<Eigen::Vector3d> point_at_distances(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& distances) {
  const auto ball = best_fit(points, distances, false);
  return ball ? std::optional(ball->centre) : std::nullopt;
}

std::optional<Ball> ball_touched_at(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& tip_radii) {
  return best_fit(points, tip_radii, true);
}

}  // namespace artcal
