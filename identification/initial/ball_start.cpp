#include "identification/initial/ball_start.h"

#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "core/statistics.h"

namespace artcal {
namespace {

constexpr int max_iterations = 50;
constexpr double cauchy_width = 2.385;  // standard deviations
// When readings of another feature are looked for: least squares miss by this share of the radius, and a robust fit
// leaves half of the readings within that share of their rms.
constexpr double gross_miss = 0.2;
constexpr double strangers_only = 0.05;
constexpr Eigen::Index min_for_robust = 6;

/// Points from their own mean, and where a ball's centre is by equations that are linear in it.
struct Centred {
  Eigen::Vector3d mean;
  Eigen::Matrix3Xd p;
  double size = 0.0;
  Eigen::Vector3d start;
};

// |p − c|² = ρ² less its mean, linear in c: 2 pᵀc + constant = |p|² − ρ². Nothing where that does not tell c.
std::optional<Centred> centred(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& rho) {
  Centred centred;
  centred.mean = points.rowwise().mean();
  centred.p = points.colwise() - centred.mean;
  centred.size = centred.p.norm() / std::sqrt(static_cast<double>(points.cols()));
  Eigen::MatrixX4d a(points.cols(), 4);
  a.leftCols<3>() = 2.0 * centred.p.transpose();
  a.col(3).setConstant(centred.size);
  const Eigen::VectorXd b = centred.p.colwise().squaredNorm().transpose() - rho.cwiseAbs2();
  Eigen::ColPivHouseholderQR<Eigen::MatrixX4d> qr(a);
  qr.setThreshold(1e-4);
  if (points.cols() < 4 || qr.rank() < 4) {
    return std::nullopt;
  }
  centred.start = qr.solve(b).head<3>();
  return centred;
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
  // Coordinate by coordinate: roots and quotients of several readings at once, each as of one alone.
  const Eigen::Array<double, Eigen::Dynamic, 3> points = p.transpose();
  Eigen::Array<double, Eigen::Dynamic, 3> away(p.cols(), 3);
  Eigen::ArrayXd lengths(p.cols());
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    squares = 0.0;
    for (int k = 0; k < 3; ++k) {
      away.col(k) = centre[k] - points.col(k);
    }
    lengths = ((away.col(0).square() + away.col(1).square()) + away.col(2).square()).sqrt();
    if (!(lengths > 0.0).all()) {
      return std::nullopt;
    }
    for (int k = 0; k < 3; ++k) {
      away.col(k) /= lengths;
    }
    for (Eigen::Index i = 0; i < p.cols(); ++i) {
      const Eigen::Vector3d outwards(away(i, 0), away(i, 1), away(i, 2));
      const double miss = rho[i] - lengths[i];
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
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
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

// The best of the fits begun at the linear centre and, because readings on half a ball that scatter by a good part of
// its radius fit one on the wrong side of them as well, on either side of the readings. Not where the first leaves
// less than a tenth of how far the readings are from lying in a plane: two balls of one size can only both pass that
// near through readings that lie in the plane in which they meet.
std::optional<Eigen::Vector3d> best_centre(const Centred& points, const Eigen::VectorXd& rho) {
  std::optional<Fitted> best = refine_centre(points.p, rho, points.size, points.start);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(points.p * points.p.transpose());
  if (!best || best->squares > 0.01 * eigen.eigenvalues()[0]) {
    const Eigen::Vector3d aside = 0.5 * rho.mean() * eigen.eigenvectors().col(0);
    for (const Eigen::Vector3d& centre : {aside, Eigen::Vector3d(-aside)}) {
      const auto fit = refine_centre(points.p, rho, points.size, centre);
      // The first stays unless another is clearly better, so that the digits do not depend on rounding.
      if (fit && (!best || fit->squares < (1.0 - 1e-6) * best->squares)) {
        best = fit;
      }
    }
  }
  return best ? std::optional<Eigen::Vector3d>(best->ball.centre) : std::nullopt;
}

double median_of(const Eigen::VectorXd& values) {
  std::vector<double> all(values.begin(), values.end());
  return median(all);
}

Eigen::VectorXd misses_of_points(const Eigen::Matrix3Xd& p, const Eigen::VectorXd& rho, const Eigen::Vector3d& centre) {
  return ((p.colwise() - centre).colwise().norm().transpose() - rho).cwiseAbs();
}

// Cauchy's loss by iterated reweighting, its scale the median of the misses, begun at the median of the points:
// readings of another feature among the ball's do not move it.
Eigen::Vector3d robust_centre(const Eigen::Matrix3Xd& p, const Eigen::VectorXd& rho) {
  Eigen::Vector3d centre(median_of(p.row(0)), median_of(p.row(1)), median_of(p.row(2)));
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const double scale =
        std::max(1e-6 * rho.mean(), cauchy_width * sigma_per_median() * median_of(misses_of_points(p, rho, centre)));
    Eigen::Matrix3d normal = 1e-12 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < p.cols(); ++i) {
      const Eigen::Vector3d away = centre - p.col(i);
      const double length = std::max(away.norm(), 1e-9);
      const double miss = rho[i] - length;
      const double weight = 1.0 / (1.0 + miss * miss / (scale * scale));
      normal += weight / (length * length) * away * away.transpose();
      gradient += weight * miss / length * away;
    }
    const Eigen::Vector3d step = normal.ldlt().solve(gradient);
    centre += step;
    if (step.norm() <= 1e-9 * rho.mean()) {
      break;
    }
  }
  return centre;
}

// Least squares, unless they miss by a good part of the radius where nearly all readings lie on a sphere: then some are
// another feature's, and a fit with a loss must begin at the sphere of the others.
Eigen::Vector3d without_strangers(const Eigen::Matrix3Xd& p, const Eigen::VectorXd& rho,
                                  const Eigen::Vector3d& centre) {
  const double rms = misses_of_points(p, rho, centre).norm() / std::sqrt(static_cast<double>(p.cols()));
  if (p.cols() < min_for_robust || rms < gross_miss * rho.mean()) {
    return centre;
  }
  const Eigen::Vector3d robust = robust_centre(p, rho);
  return robust.allFinite() && median_of(misses_of_points(p, rho, robust)) < strangers_only * rms ? robust : centre;
}

}  // namespace

std::optional<Eigen::Vector3d> point_at_distances(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& distances) {
  const auto about_mean = centred(points, distances);
  const auto centre = about_mean ? best_centre(*about_mean, distances) : std::nullopt;
  if (!centre) {
    return std::nullopt;
  }
  return without_strangers(about_mean->p, distances, *centre) + about_mean->mean;
}

std::optional<Eigen::Vector3d> point_on_the_other_side(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& distances,
                                                       const Eigen::Vector3d& point) {
  constexpr double distinct = 1e-3;  // of the distances
  const Eigen::Vector3d mean = points.rowwise().mean();
  const Eigen::Matrix3Xd p = points.colwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(p * p.transpose());
  const Eigen::Vector3d normal = eigen.eigenvectors().col(0);
  const Eigen::Vector3d from = point - mean;
  const double size = p.norm() / std::sqrt(static_cast<double>(p.cols()));
  const auto fit = refine_centre(p, distances, size, from - 2.0 * normal.dot(from) * normal);
  const bool is_another =
      fit && fit->ball.centre.allFinite() && (fit->ball.centre - from).norm() > distinct * distances.mean();
  return is_another ? std::optional<Eigen::Vector3d>(fit->ball.centre + mean) : std::nullopt;
}

std::optional<Ball> ball_touched_at(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& tip_radii) {
  const auto about_mean = centred(points, tip_radii);
  const auto fit =
      about_mean ? refine_ball(about_mean->p, tip_radii, about_mean->size, {about_mean->start, 0.0}) : std::nullopt;
  return fit ? std::optional(Ball{fit->ball.centre + about_mean->mean, fit->ball.radius}) : std::nullopt;
}

}  // namespace artcal
