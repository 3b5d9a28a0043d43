#include "fitting/segmentation/spheres/sphere_surface_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "core/statistics.h"

namespace artcal::segmentation {
namespace {

struct Shell {
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  std::vector<double> distances;  // without sign
};

Shell shell_of(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& centre, double radius, double width) {
  Shell shell;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d way = points.col(i) - centre;
    const double length = way.norm();
    const double d = length - radius;
    if (std::abs(d) < width && length > 0.0) {
      const Eigen::Vector3d u = way / length;
      shell.directions.noalias() += u * u.transpose();
      shell.pull += d * u;
      shell.distances.push_back(std::abs(d));
    }
  }
  return shell;
}

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::optional<SphereFit> fit_to_surface(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& start, double radius,
                                        double width) {
  const double rounding = 64.0 * std::numeric_limits<double>::epsilon() *
                          (radius + (points.cols() > 0 ? points.cwiseAbs().maxCoeff() : 0.0));
  SphereFit sphere{start, radius};
  const double widest = width;
  constexpr int max_steps = 40;
  for (int step = 0; step < max_steps; ++step) {
    Shell shell = shell_of(points, sphere.centre, radius, width);
    if (shell.distances.size() < 4) {
      return std::nullopt;
    }
    const Eigen::LDLT<Eigen::Matrix3d> normal(shell.directions);
    const double weakest = normal.vectorD().minCoeff();
    if (!(weakest > 1e-6 * static_cast<double>(shell.distances.size()))) {
      return std::nullopt;
    }
    const Eigen::Vector3d move = normal.solve(shell.pull);
    if (move.norm() > radius) {
      return std::nullopt;
    }
    sphere.centre += move;
    sphere.noise = std::max(rounding, sigma_per_median() * median_of(shell.distances));
    // Not at once: in a wide shell the median still holds what the centre's own error makes of distances.
    const double next = std::max(4.0 * sphere.noise, 0.5 * width);
    const bool converged = move.norm() < 1e-3 * sphere.noise && std::abs(next - width) < 1e-3 * width;
    width = std::min(next, widest);
    if (converged) {
      break;
    }
  }
  return sphere;
}

}  // namespace artcal::segmentation
