#include "fitting/segmentation/spheres/own_surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/statistics.h"
#include "fitting/segmentation/spheres/direction_cells.h"
#include "fitting/segmentation/spheres/sphere_coverage.h"

namespace artcal::segmentation {
namespace {

constexpr double own_limit = 4.0;    // standard deviations
constexpr double near_limit = 12.0;  // what scatters lies between the two, what is another surface beyond
constexpr double reach = 0.5;        // of the radius; farther away is not this sphere's business
constexpr int telling_count = 8;     // points from which a cell's scatter means something

struct SurfaceCell {
  int own = 0, near = 0, far = 0;
  double sum = 0.0, squares = 0.0;  // of the own distances

  [[nodiscard]] int total() const { return own + near + far; }
  [[nodiscard]] double mean() const { return sum / own; }
  [[nodiscard]] double variance() const { return std::max(0.0, squares / own - mean() * mean()); }
};

double share_of(int part, int total) { return static_cast<double>(part) / static_cast<double>(total); }

double median_or(std::vector<double> values, double otherwise) {
  if (values.empty()) {
    return otherwise;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// About 25 points in each cell that is seen, where a scanner sees a third of a ball.
int cells_per_edge(const Eigen::VectorXd& distances, double radius) {
  const auto count = static_cast<double>((distances.array().abs() < 0.1 * radius).count());
  return std::clamp(static_cast<int>(std::sqrt(count / 50.0)), 3, 32);
}

Eigen::VectorXd distances_to(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& centre, double radius) {
  return (points.colwise() - centre).colwise().norm().transpose().array() - radius;
}

// What other cells have too is the scanner's, not another surface's.
struct Typical {
  double near_share;
  double variance;
  double mean;  // without sign
};

Typical typical_of(const std::vector<SurfaceCell>& cells, double noise) {
  std::vector<double> near_shares, variances, means;
  for (const SurfaceCell& cell : cells) {
    if (cell.own >= telling_count && 2 * cell.own > cell.total()) {
      near_shares.push_back(share_of(cell.near, cell.own + cell.near));
      variances.push_back(cell.variance());
      means.push_back(std::abs(cell.mean()));
    }
  }
  return {median_or(near_shares, 0.0), median_or(variances, noise * noise), median_or(means, 0.0)};
}

bool is_clean(const SurfaceCell& cell, const Typical& typical) {
  if (cell.own == 0 || (cell.far >= 2 && cell.far > 0.25 * cell.total())) {
    return false;
  }
  const int close = cell.own + cell.near;
  const double expected = typical.near_share;
  if (cell.near >= 2 &&
      share_of(cell.near, close) >
          expected + 0.05 + 3.0 * std::sqrt(expected * (1.0 - expected) / static_cast<double>(close))) {
    return false;
  }
  const double chance = 3.0 * std::sqrt(2.0 / std::max(1, cell.own));  // of a variance from so many points
  const double stands_off = std::abs(cell.mean()) - 2.0 * std::sqrt(typical.variance / cell.own);
  return cell.own < telling_count || (cell.variance() < (1.5 + chance) * typical.variance &&
                                      stands_off < std::max(0.5 * std::sqrt(typical.variance), 3.0 * typical.mean));
}

Eigen::Vector3d fitted_centre(const Eigen::Matrix3Xd& points, const std::vector<char>& is_own, Eigen::Vector3d centre,
                              double radius) {
  constexpr int steps = 3;  // each gains the digits of noise/radius
  for (int step = 0; step < steps; ++step) {
    Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if (is_own[static_cast<std::size_t>(i)] != 0) {
        const Eigen::Vector3d way = points.col(i) - centre;
        const double length = way.norm();
        directions.noalias() += way * way.transpose() / (length * length);
        pull += (length - radius) / length * way;
      }
    }
    centre += directions.ldlt().solve(pull);
  }
  return centre;
}

// How much of the sphere its own points show; some thousand of them are enough to see that.
double coverage_of(const Eigen::Matrix3Xd& points, const Surface& surface) {
  constexpr int enough = 20'000;
  const int step = std::max(1, surface.count / enough);
  std::vector<Eigen::Index> own;
  for (int i = 0, k = 0; i < static_cast<int>(surface.is_own.size()); ++i) {
    if (surface.is_own[static_cast<std::size_t>(i)] != 0 && k++ % step == 0) {
      own.push_back(i);
    }
  }
  return sphere_coverage(points(Eigen::all, own).colwise() - surface.sphere.centre);
}

double narrowest_extent(const Eigen::Matrix3Xd& points, const Surface& surface) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (surface.is_own[static_cast<std::size_t>(i)] != 0) {
      const Eigen::Vector3d u = (points.col(i) - surface.sphere.centre).normalized();
      squares.noalias() += u * u.transpose();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(squares / std::max(1, surface.count));
  return std::sqrt(std::max(0.0, eigen.eigenvalues()(0)));
}

}  // namespace

Surface own_surface(const Eigen::Matrix3Xd& points, const SphereFit& start, double radius) {
  Surface surface;
  surface.sphere = start;
  const auto count = static_cast<std::size_t>(points.cols());
  Eigen::VectorXd distances = distances_to(points, start.centre, radius);
  const DirectionCells directions(cells_per_edge(distances, radius));
  std::vector<std::size_t> cell_of(count);
  for (std::size_t i = 0; i < count; ++i) {
    cell_of[i] = directions.cell_of(points.col(static_cast<Eigen::Index>(i)) - start.centre);
  }
  constexpr int max_rounds = 10;
  for (int round = 0; round < max_rounds; ++round) {
    const double noise = surface.sphere.noise;
    std::vector<SurfaceCell> cells(directions.size());
    for (std::size_t i = 0; i < count; ++i) {
      const double d = distances(static_cast<Eigen::Index>(i));
      SurfaceCell& cell = cells[cell_of[i]];
      if (std::abs(d) <= own_limit * noise) {
        ++cell.own;
        cell.sum += d;
        cell.squares += d * d;
      } else if (std::abs(d) <= near_limit * noise) {
        ++cell.near;
      } else if (std::abs(d) <= reach * radius) {
        ++cell.far;
      }
    }
    const Typical typical = typical_of(cells, noise);
    std::vector<char> is_own(count, 0);
    std::vector<double> own_distances;
    std::vector<char> clean(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      clean[c] = is_clean(cells[c], typical) ? 1 : 0;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double d = std::abs(distances(static_cast<Eigen::Index>(i)));
      if (clean[cell_of[i]] != 0 && d <= own_limit * noise) {
        is_own[i] = 1;
        own_distances.push_back(d);
      }
    }
    const bool converged = is_own == surface.is_own;
    surface.is_own = std::move(is_own);
    surface.count = static_cast<int>(own_distances.size());
    if (converged || surface.count < 4) {
      break;
    }
    surface.sphere.centre = fitted_centre(points, surface.is_own, surface.sphere.centre, radius);
    distances = distances_to(points, surface.sphere.centre, radius);
    for (std::size_t i = 0, k = 0; i < count; ++i) {
      if (surface.is_own[i] != 0) {
        own_distances[k++] = std::abs(distances(static_cast<Eigen::Index>(i)));
      }
    }
    surface.sphere.noise = std::max(1e-12 * radius, sigma_per_median() * median_or(own_distances, noise));
  }
  surface.coverage = coverage_of(points, surface);
  surface.narrowest = narrowest_extent(points, surface);
  return surface;
}

}  // namespace artcal::segmentation
