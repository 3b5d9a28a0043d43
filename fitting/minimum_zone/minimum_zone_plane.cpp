#include "fitting/minimum_zone/minimum_zone_plane.h"

#include <cmath>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/Width_3.h>
#include <CGAL/Width_default_traits_3.h>
#include <CGAL/convex_hull_3.h>

namespace artcal::fitting {
namespace {

using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Homogeneous<CGAL::Gmpz>;
using Width = CGAL::Width_3<CGAL::Width_default_traits_3<Exact>>;

// Coordinates become integers of 2⁻⁵² of the cloud's size: no coarser than the doubles were.
constexpr double unit = 0x1.0p-52;

std::vector<Predicates::Point_3> as_points(const Cloud& cloud) {
  std::vector<Predicates::Point_3> points;
  for (const auto& p : cloud.points.colwise()) {
    points.emplace_back(p.x(), p.y(), p.z());
  }
  return points;
}

// Only corners of the hull can bound the zone. The hull's own predicates are exact and fast.
std::vector<Exact::Point_3> hull_corners(const Cloud& cloud) {
  const auto points = as_points(cloud);
  std::vector<Predicates::Point_3> corners;
  CGAL::extreme_points_3(points, std::back_inserter(corners));
  std::vector<Exact::Point_3> exact;
  for (const auto& p : corners) {
    exact.emplace_back(CGAL::Gmpz(std::round(p.x() / unit)), CGAL::Gmpz(std::round(p.y() / unit)),
                       CGAL::Gmpz(std::round(p.z() / unit)));
  }
  return exact;
}

// Four exact points in one plane have no hull with an inside, which the width asks for.
bool coplanar(const std::vector<Exact::Point_3>& points) {
  std::size_t third = 2;
  while (third < points.size() && CGAL::collinear(points[0], points[1], points[third])) {
    ++third;
  }
  for (std::size_t i = 2; i < points.size() && third < points.size(); ++i) {
    if (!CGAL::coplanar(points[0], points[1], points[third], points[i])) {
      return false;
    }
  }
  return true;
}

// Integers of any length to a unit vector: brought to one size first, so that none overflows a double.
Eigen::Vector3d direction_of(const Exact::Vector_3& v) {
  const CGAL::Gmpz largest = std::max({CGAL::abs(v.hx()), CGAL::abs(v.hy()), CGAL::abs(v.hz())});
  const auto bits = static_cast<long>(mpz_sizeinbase(largest.mpz(), 2));
  const auto shrunk = [bits](const CGAL::Gmpz& value) {
    long exponent = 0;
    const double mantissa = mpz_get_d_2exp(&exponent, value.mpz());
    return std::ldexp(mantissa, static_cast<int>(exponent - bits));
  };
  return Eigen::Vector3d(shrunk(v.hx()), shrunk(v.hy()), shrunk(v.hz())).normalized();
}

}  // namespace

Plane minimum_zone_plane(const Cloud& cloud) {
  const auto corners = hull_corners(cloud);
  Plane plane{Eigen::Vector3d::Zero(), cloud.axes.col(2)};
  if (corners.size() >= 4 && !coplanar(corners)) {
    Width width(corners.begin(), corners.end());
    plane.normal = direction_of(width.get_build_direction());
  }
  const Eigen::RowVectorXd heights = plane.normal.transpose() * cloud.points;
  plane.point = 0.5 * (heights.maxCoeff() + heights.minCoeff()) * plane.normal;
  return plane;
}

}  // namespace artcal::fitting
