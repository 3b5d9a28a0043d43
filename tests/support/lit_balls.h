#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "core/normal_vector.h"
#include "core/random.h"

namespace artcal::testing {

/// Balls on stems over a plate, of which a scanner above sees only what a lamp lights: a sector of the upper half.
struct LitBalls {
  std::uint64_t seed = 1;
  std::vector<Eigen::Vector3d> centres = {Eigen::Vector3d(0.0, 0.0, 150.0)};  ///< mm
  double radius = 11.0;
  double sector = 3.141592653589793;  ///< of the lit directions about the vertical, rad: π is half of the visible half
  double lowest = 0.0;                ///< polar height down to which a ball is seen, of the radius; 0: the equator
  int points = 2000;                  ///< on each ball
  double noise = 0.01;                ///< along each axis, mm
  double mixed = 0.05;                ///< of the points on balls: spread from the lit rim down to the plate
  int stem = 100;                     ///< points on each stem, a cylinder of a third of the radius
  int plate = 5000;                   ///< points on the plate, 40 mm below the balls
};

struct LitScan {
  Eigen::Matrix3Xd points;
  std::vector<int> ball;  ///< of each point, or -1
};

/// A scan of them, as parallel rays from above meet them: even in the plan, sparse towards the equator. Truth by this
/// code alone; points of all things are shuffled.
inline LitScan scan_of(const LitBalls& settings) {
  RandomStream random(settings.seed, "lit balls");
  std::vector<std::pair<Eigen::Vector3d, int>> all;
  const auto noise = [&] { return settings.noise * normal_vector(random); };
  const double r = settings.radius;
  const double widest = std::sqrt(1.0 - settings.lowest * settings.lowest);
  for (std::size_t b = 0; b < settings.centres.size(); ++b) {
    const Eigen::Vector3d& c = settings.centres[b];
    const double side = random.uniform(0.0, 6.283185307179586);
    const auto lit_angle = [&] { return side + random.uniform(0.0, settings.sector); };
    for (int i = 0; i < settings.points; ++i) {
      const double angle = lit_angle();
      const double rho = widest * std::sqrt(random.uniform());
      const double z = std::sqrt(std::max(0.0, 1.0 - rho * rho));
      all.emplace_back(c + r * Eigen::Vector3d(rho * std::cos(angle), rho * std::sin(angle), z) + noise(),
                       static_cast<int>(b));
    }
    const int mixed = static_cast<int>(settings.mixed * settings.points);
    for (int i = 0; i < mixed; ++i) {
      const double angle = lit_angle();
      const double rho = r * random.uniform(0.97, 1.03);
      all.emplace_back(
          c + Eigen::Vector3d(rho * std::cos(angle), rho * std::sin(angle), random.uniform(-40.0, 0.2 * r)) + noise(),
          -1);
    }
    for (int i = 0; i < settings.stem; ++i) {
      const double angle = lit_angle();
      all.emplace_back(
          c + Eigen::Vector3d(r / 3.0 * std::cos(angle), r / 3.0 * std::sin(angle), random.uniform(-40.0, -0.95 * r)) +
              noise(),
          -1);
    }
  }
  Eigen::Vector3d low = settings.centres.front(), high = low;
  for (const Eigen::Vector3d& c : settings.centres) {
    low = low.cwiseMin(c);
    high = high.cwiseMax(c);
  }
  for (int i = 0; i < settings.plate; ++i) {
    all.emplace_back(Eigen::Vector3d(random.uniform(low.x() - 60.0, high.x() + 60.0),
                                     random.uniform(low.y() - 60.0, high.y() + 60.0), low.z() - 40.0) +
                         noise(),
                     -1);
  }
  for (std::size_t i = all.size() - 1; i > 0; --i) {
    std::swap(all[i], all[static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1))]);
  }
  LitScan scan{Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(all.size())), {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    scan.points.col(static_cast<Eigen::Index>(i)) = all[i].first;
    scan.ball.push_back(all[i].second);
  }
  return scan;
}

}  // namespace artcal::testing
