#include "artefacts/simulation/pattern.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/kabsch.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double golden_angle = 2.39996322972865332;  // rad, π·(3 − √5)

Eigen::Vector3d from_pole(double polar, double azimuth) {
  return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

}  // namespace

std::vector<Eigen::Vector3d> iso_directions() {
  constexpr double step = 22.5 * units::degree;
  std::vector<Eigen::Vector3d> directions{Eigen::Vector3d::UnitZ()};
  for (int ring = 1; ring <= 4; ++ring) {
    const int count = ring % 2 == 1 ? 4 : 8;
    for (int i = 0; i < count; ++i) {
      directions.push_back(from_pole(ring * step, ring * step + 2.0 * std::numbers::pi * i / count));
    }
  }
  return directions;
}

Eigen::Matrix3d rotation_to(const Eigen::Vector3d& axis) { return rotation_onto(Eigen::Vector3d::UnitZ(), axis); }

std::vector<Eigen::Vector3d> directions_on_ball(const PlannedProbing& probing, RandomStream& random) {
  std::vector<Eigen::Vector3d> directions;
  if (probing.pattern == TouchPattern::Iso25) {
    directions = iso_directions();
  } else if (!probing.scan) {
    // Systematic in the height and by the golden angle about the pole (a spherical Fibonacci lattice), from a random
    // start: each point is uniform over the cap, and however few they are, they do not crowd on a part of it.
    const double start = random.uniform();
    const double azimuth = random.uniform(0.0, 2.0 * std::numbers::pi);
    for (int i = 0; i < probing.points; ++i) {
      const double height = 1.0 - (1.0 - std::cos(probing.cap)) * (i + start) / probing.points;
      directions.push_back(from_pole(std::acos(height), azimuth + golden_angle * i));
    }
  } else {
    for (int i = 0; i < probing.points; ++i) {
      // Equal steps of the height are equal areas of a sphere.
      const double height = random.uniform(std::cos(probing.cap), 1.0);
      directions.push_back(from_pole(std::acos(height), random.uniform(0.0, 2.0 * std::numbers::pi)));
    }
  }
  const Eigen::Matrix3d base_from_pole = rotation_to(probing.pole_in_base);
  for (Eigen::Vector3d& direction : directions) {
    direction = (base_from_pole * direction).normalized();
  }
  return directions;
}

double centre_dilution(const std::vector<Eigen::Vector3d>& directions) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  for (const Eigen::Vector3d& direction : directions) {
    const Eigen::Vector4d row = direction.homogeneous();
    normal += row * row.transpose();
  }
  const Eigen::FullPivLU<Eigen::Matrix4d> factor(normal);
  if (!factor.isInvertible()) {
    return std::numeric_limits<double>::infinity();
  }
  const Eigen::Matrix3d of_centre = factor.inverse().topLeftCorner<3, 3>();
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(of_centre).eigenvalues()(2));
}

std::vector<Eigen::Vector2d> places_on_plane(const PlannedProbing& probing, RandomStream& random) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < probing.points; ++i) {
    const double x = random.uniform(-0.5, 0.5);
    const double y = random.uniform(-0.5, 0.5);
    places.emplace_back(probing.extent.x() * x, probing.extent.y() * y);
  }
  return places;
}

}  // namespace artcal
