#include "identification/postures.h"

#include <cmath>
#include <numbers>

#include "artefacts/virtual_probing.h"

namespace artcal {
namespace {

constexpr int most_attempts = 20;  // at one place before it counts as out of reach

}  // namespace

Eigen::VectorXd random_posture(const Arm& arm, RandomStream& random) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(arm.joints.size()));
  for (double& angle : q) {
    angle = random.uniform(-std::numbers::pi, std::numbers::pi);
  }
  return q;
}

std::optional<Eigen::VectorXd> posture_at(const Arm& arm, int probe, const Eigen::Vector3d& place_in_base,
                                          RandomStream& random) {
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    if (auto q = reach_point(arm, probe, place_in_base, random_posture(arm, random))) {
      return q;
    }
  }
  return std::nullopt;
}

std::vector<Eigen::Vector3d> pattern_of_25() {
  constexpr double step = std::numbers::pi / 8.0;
  std::vector<Eigen::Vector3d> directions{Eigen::Vector3d::UnitZ()};
  int ring = 0;
  for (const int count : {4, 8, 4, 8}) {
    const double from_pole = step * ++ring;
    for (int i = 0; i < count; ++i) {
      const double round = 2.0 * std::numbers::pi * i / count + step * ring;
      directions.emplace_back(std::sin(from_pole) * std::cos(round), std::sin(from_pole) * std::sin(round),
                              std::cos(from_pole));
    }
  }
  return directions;
}

}  // namespace artcal
