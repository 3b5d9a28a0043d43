#include "fitting/segmentation/spheres/sphere_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <Eigen/Geometry>

#include "fitting/segmentation/spheres/direction_cells.h"

namespace artcal::segmentation {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
constexpr double whole = 4.0 * std::numbers::pi;

/// A triangle on the unit sphere.
struct Facet {
  double area;    ///< solid angle, sr
  double circle;  ///< solid angle inside its circumscribed circle, in which no other point lies
};

// The mean direction of each cell that holds points.
std::vector<Eigen::Vector3d> one_per_cell(const Eigen::Matrix3Xd& directions, int per_edge) {
  const DirectionCells cells(per_edge);
  std::vector<Eigen::Vector3d> sums(cells.size(), Eigen::Vector3d::Zero());
  for (Eigen::Index i = 0; i < directions.cols(); ++i) {
    sums[cells.cell_of(directions.col(i))] += directions.col(i).normalized();
  }
  std::erase_if(sums, [](const Eigen::Vector3d& sum) { return sum.squaredNorm() == 0.0; });
  for (Eigen::Vector3d& sum : sums) {
    sum.normalize();
  }
  return sums;
}

// Each once: a scanner that stands still sees no more of the ball.
std::vector<Eigen::Vector3d> distinct(const Eigen::Matrix3Xd& directions) {
  std::vector<Eigen::Vector3d> some;
  for (Eigen::Index i = 0; i < directions.cols(); ++i) {
    some.emplace_back(directions.col(i).normalized());
  }
  std::sort(some.begin(), some.end(), [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  some.erase(std::unique(some.begin(), some.end()), some.end());
  return some;
}

// Few enough for a triangulation, and as even as they may be: a scanner sees the rim of a ball under a small angle.
std::vector<Eigen::Vector3d> evened(const Eigen::Matrix3Xd& directions) {
  constexpr Eigen::Index enough = 600;
  constexpr double points_per_cell = 6.0;  // so that hardly one that is seen is empty
  constexpr int finest = 64;
  if (directions.cols() <= enough) {
    return distinct(directions);
  }
  std::vector<Eigen::Vector3d> even = one_per_cell(directions, 4);
  for (int per_edge = 6; per_edge <= finest; per_edge += per_edge / 2) {
    auto finer = one_per_cell(directions, per_edge);
    if (static_cast<double>(finer.size()) * points_per_cell > static_cast<double>(directions.cols()) ||
        static_cast<Eigen::Index>(finer.size()) > 2 * enough) {
      break;
    }
    even = std::move(finer);
  }
  return even;
}

double solid_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return 2.0 * std::atan2(std::abs(a.dot(b.cross(c))), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

std::vector<Facet> facets_of(const std::vector<Eigen::Vector3d>& directions) {
  std::vector<Kernel::Point_3> points;
  for (const Eigen::Vector3d& u : directions) {
    points.emplace_back(u.x(), u.y(), u.z());
  }
  Mesh mesh;
  CGAL::convex_hull_3(points.begin(), points.end(), mesh);
  std::vector<Facet> facets;
  const auto before = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  for (const auto face : mesh.faces()) {
    std::array<Eigen::Vector3d, 3> corners;
    std::size_t corner = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      const auto& p = mesh.point(vertex);
      corners[std::min<std::size_t>(corner++, 2)] = {p.x(), p.y(), p.z()};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), before), corners.end());
    const Eigen::Vector3d across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double height = across.norm() > 0.0 ? across.normalized().dot(corners[0]) : -1.0;
    facets.push_back({solid_angle(corners[0], corners[1], corners[2]), 0.5 * whole * (1.0 - height)});
  }
  // CGAL's order of the facets, and of the corners of each, depends on where in memory they lie.
  std::sort(facets.begin(), facets.end(),
            [](const Facet& a, const Facet& b) { return std::tie(a.circle, a.area) < std::tie(b.circle, b.area); });
  return facets;
}

}  // namespace

double sphere_coverage(const Eigen::Matrix3Xd& directions) {
  constexpr std::size_t fewest = 4;
  // Of evenly spread random points one circle in two thousand holds the place of more than ten of them.
  constexpr double widest_circle = 10.0;
  const auto even = evened(directions);
  if (even.size() < fewest) {
    return 0.0;
  }
  const auto count = static_cast<double>(even.size());
  const std::vector<Facet> facets = facets_of(even);
  double seen = whole;
  constexpr int max_rounds = 50;
  for (int round = 0; round < max_rounds; ++round) {
    double area = 0.0;
    int taken = 0;
    for (const Facet& facet : facets) {
      if (facet.circle <= widest_circle * seen / count) {
        area += facet.area;
        ++taken;
      }
    }
    const double next = taken == 0 ? 0.0 : std::min(seen, 2.0 * count * area / taken);
    if (next == seen || taken == 0) {
      seen = next;
      break;
    }
    seen = next;
  }
  return std::min(1.0, seen / whole);
}

}  // namespace artcal::segmentation
