#include "fitting/least_squares/axis_start.h"

#include <algorithm>
#include <numbers>

#include <Eigen/Geometry>

#include "fitting/least_squares/round_models.h"
#include "fitting/least_squares/row_reducer.h"
#include "fitting/small_matrix.h"

namespace artcal::fitting {
namespace {

constexpr int net_size = 200;  // directions over a half sphere: about 10° apart

// Fibonacci's spiral: even, without a preferred plane.
Eigen::Vector3d net_direction(int i) {
  const double z = (i + 0.5) / net_size;
  const double angle = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// From the axis direction a, the axis's point c across from the centroid, the radius there and ψ.
RoundState state_of(const Eigen::Vector3d& a, const Eigen::Vector3d& c, double radius, double psi) {
  const double off = c.norm();
  const Eigen::Vector3d n = off > 1e-3 * radius ? Eigen::Vector3d(-c / off) : a.unitOrthogonal();
  RoundState state;
  state.frame.col(0) = std::cos(psi) * n - std::sin(psi) * a;
  state.frame.col(2) = std::sin(psi) * n + std::cos(psi) * a;
  state.frame.col(1) = state.frame.col(2).cross(state.frame.col(0));
  state.point = c + radius * n;
  state.curvature = std::cos(psi) / radius;
  state.taper = std::sin(psi) / radius;
  return state;
}

// The axis's point abreast of the centroid, for an axis along a. With (u, v) across it and h along it,
// u² + v² = 2·u0·u + 2·v0·v + t + s·h + e·h² is linear; a cylinder is s = e = 0. A cone has e = tan² ψ, which two rings
// of points leave free: without it, their radii are interpolated, and the centre is the same.
template <int Terms>
Eigen::Vector3d centre_across(const Cloud& cloud, const Eigen::Vector3d& a) {
  const Eigen::Vector3d u = a.unitOrthogonal();
  const Eigen::Vector3d v = a.cross(u);
  RowReducer<Terms + 1> reducer;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    const auto p = cloud.points.col(i);
    const double x = u.dot(p);
    const double y = v.dot(p);
    const double h = a.dot(p);
    const double powers[] = {2.0 * x, 2.0 * y, 1.0, h, h * h};
    Eigen::Matrix<double, 1, Terms + 1> row;
    for (int term = 0; term < Terms; ++term) {
      row(term) = powers[term];
    }
    row(Terms) = x * x + y * y;
    reducer.add(cloud.root_weight(i) * row);
  }
  const auto triangle = reducer.triangle();
  const Eigen::Matrix<double, Terms, 1> solved = least_squares_solution(triangle.template topLeftCorner<Terms, Terms>(),
                                                                        triangle.template topRightCorner<Terms, 1>());
  return solved(0) * u + solved(1) * v;
}

// Radius and opening about a known axis: distances from it are a straight line over the height.
template <bool Tapered>
RoundState about(const Cloud& cloud, const Eigen::Vector3d& a, const Eigen::Vector3d& c) {
  constexpr double least_radius = 1e-2;
  constexpr int n = Tapered ? 2 : 1;
  RowReducer<n + 1> reducer;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d from_axis = cloud.points.col(i) - c;
    const double h = a.dot(from_axis);
    Eigen::Matrix<double, 1, n + 1> row;
    row(0) = 1.0;
    if constexpr (Tapered) {
      row(1) = h;
    }
    row(n) = (from_axis - h * a).norm();
    reducer.add(cloud.root_weight(i) * row);
  }
  const auto triangle = reducer.triangle();
  const Eigen::Matrix<double, n, 1> line =
      least_squares_solution(triangle.template topLeftCorner<n, n>(), triangle.template topRightCorner<n, 1>());
  return state_of(a, c, std::max(line(0), least_radius), Tapered ? std::atan(line(n - 1)) : 0.0);
}

template <bool Tapered>
RoundState along(const Cloud& cloud, const Eigen::Vector3d& a) {
  return about<Tapered>(cloud, a, centre_across < Tapered ? 4 : 3 > (cloud, a));
}

// The paraboloid z = g0 + g1·x + g2·y + (h1·x² + 2·h2·x·y + h3·y²)/2 over the points' own plane: its two
// principal directions are the rulings that a patch of a few degrees can have.
struct Paraboloid {
  Eigen::Vector3d point, normal;
  Eigen::Matrix<double, 3, 2> principal;
  Eigen::Vector2d curvature;
};

Paraboloid paraboloid(const Cloud& cloud) {
  RowReducer<7> reducer;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.axes.transpose() * cloud.points.col(i);
    Eigen::Matrix<double, 1, 7> row;
    row << 1.0, p.x(), p.y(), 0.5 * p.x() * p.x(), p.x() * p.y(), 0.5 * p.y() * p.y(), p.z();
    reducer.add(cloud.root_weight(i) * row);
  }
  const auto triangle = reducer.triangle();
  const Eigen::Matrix<double, 6, 1> z =
      least_squares_solution(triangle.topLeftCorner<6, 6>(), triangle.topRightCorner<6, 1>());
  Paraboloid shape;
  shape.point = cloud.axes.col(2) * z(0);
  shape.normal = (cloud.axes * Eigen::Vector3d(-z(1), -z(2), 1.0)).normalized();
  const Eigen::Matrix2d hessian{{z(3), z(4)}, {z(4), z(5)}};
  const double turn = 0.5 * std::atan2(2.0 * z(4), z(3) - z(5));
  for (int j = 0; j < 2; ++j) {
    const double angle = turn + 0.5 * std::numbers::pi * j;
    const Eigen::Vector2d d{std::cos(angle), std::sin(angle)};
    const Eigen::Vector3d lifted{d.x(), d.y(), d.x() * z(1) + d.y() * z(2)};
    const Eigen::Vector3d tangent = cloud.axes * lifted;
    shape.principal.col(j) = (tangent - shape.normal * shape.normal.dot(tangent)).normalized();
    shape.curvature(j) = -d.dot(hessian * d);
  }
  return shape;
}

// A surface that touches the paraboloid, ruled along one principal direction, its apex at ± the distance
// that opens it by ψ.
RoundState touching(const Paraboloid& shape, int ruling, double psi) {
  RoundState state;
  state.point = shape.point;
  state.frame.col(0) = shape.normal;
  state.frame.col(2) = shape.principal.col(ruling);
  state.frame.col(1) = state.frame.col(2).cross(state.frame.col(0));
  const double k = shape.curvature(1 - ruling);
  state.curvature = std::abs(k) > 1e-9 ? k : 1e-9;
  state.taper = state.curvature * std::tan(psi);
  return state;
}

template <bool Tapered>
double cost_of(const Cloud& cloud, const RoundState& state) {
  constexpr int n = AxialModel<Tapered>::size;
  double cost = 0.0;
  AxialModel<Tapered>{cloud}.rows(state, [&](const Eigen::Matrix<double, 1, n + 1>& row) { cost += row(n) * row(n); });
  return std::isfinite(cost) ? cost : std::numeric_limits<double>::max();
}

template <bool Tapered>
std::vector<RoundState> best(const Cloud& cloud, int count) {
  std::vector<std::pair<double, RoundState>> all;
  const auto consider = [&](const RoundState& state) { all.emplace_back(cost_of<Tapered>(cloud, state), state); };
  for (int i = 0; i < net_size; ++i) {
    // In the cloud's own axes, so that turning the points turns the starts.
    const Eigen::Vector3d a = cloud.axes * net_direction(i);
    consider(along<Tapered>(cloud, a));
    if constexpr (Tapered) {
      consider(about<Tapered>(cloud, a, centre_across<5>(cloud, a)));
    }
  }
  for (int i = 0; i < 3; ++i) {
    consider(along<Tapered>(cloud, cloud.axes.col(i)));
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<RoundState> starts;
  for (int i = 0; i < std::min<int>(count, static_cast<int>(all.size())); ++i) {
    starts.push_back(all[static_cast<std::size_t>(i)].second);
  }
  // A patch's own starts are few and always tried: where they matter the net is too coarse to see it.
  const Paraboloid shape = paraboloid(cloud);
  for (int ruling = 0; ruling < 2; ++ruling) {
    for (const double psi : {0.0, 0.2, -0.2, 0.7, -0.7, 1.2, -1.2}) {
      if (Tapered || psi == 0.0) {
        starts.push_back(touching(shape, ruling, psi));
      }
    }
  }
  return starts;
}

}  // namespace

std::vector<RoundState> start_cylinders(const Cloud& cloud, int count) { return best<false>(cloud, count); }
std::vector<RoundState> start_cones(const Cloud& cloud, int count) { return best<true>(cloud, count); }

Cloud thinned(const Cloud& cloud, Eigen::Index count) {
  if (cloud.size() <= count) {
    return cloud;
  }
  Cloud few = cloud;
  few.points.resize(3, count);
  few.root_weights.resize(cloud.root_weights.size() == 0 ? 0 : count);
  // Multiples of the golden ratio: no step of a scanner's raster repeats in them.
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double turns = golden * static_cast<double>(i);
    const auto pick = static_cast<Eigen::Index>((turns - std::floor(turns)) * static_cast<double>(cloud.size()));
    few.points.col(i) = cloud.points.col(pick);
    if (few.root_weights.size() != 0) {
      few.root_weights(i) = cloud.root_weights(pick);
    }
  }
  return few;
}

}  // namespace artcal::fitting
