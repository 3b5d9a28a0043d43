#include "fitting/segmentation/spheres/out_of_round.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace artcal::segmentation {
namespace {

constexpr int terms = 9;
using Row = Eigen::Matrix<double, terms, 1>;
using Square = Eigen::Matrix<double, terms, terms>;

// Spherical harmonics up to the second degree, but for their factors: radius, centre, and what is neither.
Row harmonics(const Eigen::Vector3d& u) {
  Row row;
  row << 1.0, u.x(), u.y(), u.z(), u.x() * u.y(), u.y() * u.z(), u.z() * u.x(), u.x() * u.x() - u.y() * u.y(),
      3.0 * u.z() * u.z() - 1.0;
  return row;
}

// What the sum of squares loses by a fit of the first `count` harmonics: bᵀ·A⁺·b.
double explained(const Square& normal, const Row& pull, int count) {
  const Eigen::MatrixXd some = normal.topLeftCorner(count, count);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(some);
  const double least = 1e-10 * eigen.eigenvalues()(count - 1);
  double squares = 0.0;
  for (int i = 0; i < count; ++i) {
    if (eigen.eigenvalues()(i) > least) {
      squares += std::pow(eigen.eigenvectors().col(i).dot(pull.head(count)), 2) / eigen.eigenvalues()(i);
    }
  }
  return squares;
}

}  // namespace

double out_of_round(const Eigen::Matrix3Xd& points, const Surface& surface, double radius) {
  constexpr int round_terms = 4;
  constexpr int other_terms = terms - round_terms;
  // What leaves the sphere slowly is cut off where it leaves the noise, and what is left of it looks round. So what
  // lies a little farther off counts too: of a ball that are few points, of a ring or a cone that it touches many.
  constexpr double beside = 0.025;
  constexpr double beyond_chance = 8.0;  // F with 5 degrees of freedom: one in thousands, also with few points
  Square normal = Square::Zero();
  Row pull = Row::Zero();
  double squares = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d way = points.col(i) - surface.sphere.centre;
    const double d = way.norm() - radius;
    if (surface.is_own[static_cast<std::size_t>(i)] != 0 || std::abs(d) < beside * radius) {
      ++count;
      const Row row = harmonics(way.normalized());
      normal.noalias() += row * row.transpose();
      pull += d * row;
      squares += d * d;
    }
  }
  const int freedom = count - terms;
  if (freedom <= 0) {
    return 0.0;
  }
  const double all = explained(normal, pull, terms);
  const double part = all - explained(normal, pull, round_terms);
  const double variance = std::max(0.0, squares - all) / freedom;
  const bool may_be_chance = part <= beyond_chance * other_terms * variance;
  return may_be_chance ? 0.0 : std::sqrt(std::max(0.0, part - other_terms * variance) / count);
}

}  // namespace artcal::segmentation
