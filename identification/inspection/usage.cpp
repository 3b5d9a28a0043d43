#include "identification/inspection/usage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "acquisition/arm/forward_kinematics.h"
#include "artefacts/simulation/posture.h"
#include "artefacts/virtual_probing/postures.h"

namespace artcal {
namespace {

constexpr double cell = std::numbers::pi / 12.0;  // rad, of a joint's circle
constexpr int cells = 24;
constexpr double other_side = 0.05;
constexpr double shell = 0.55;  // of the reach; two shells of about the same use
constexpr int volume_cells = 16;

double covered(const Eigen::Ref<const Eigen::RowVectorXd>& angles) {
  std::set<int> used;
  for (const double q : angles) {
    const double turned = q - 2.0 * std::numbers::pi * std::floor(q / (2.0 * std::numbers::pi));
    used.insert(std::min(cells - 1, static_cast<int>(turned / cell)));
  }
  return static_cast<double>(used.size()) / cells;
}

// The nearest of the 26 directions (-1, 0, 1)³ without zero.
std::tuple<int, int, int> nearest_direction(const Eigen::Vector3d& stylus) {
  std::tuple<int, int, int> best;
  double most = -1.0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const Eigen::Vector3d direction(x, y, z);
        if (const double along = x == 0 && y == 0 && z == 0 ? -1.0 : stylus.dot(direction.normalized()); along > most) {
          most = along;
          best = {x, y, z};
        }
      }
    }
  }
  return best;
}

struct ElbowSides {
  int left = 0, right = 0;
  [[nodiscard]] bool on(int count) const { return count > other_side * std::max(1, left + right); }
};

}  // namespace

Usage usage_of(const Recording& recording) {
  Usage usage;
  const Eigen::MatrixXd& joints = recording.joints;
  if (recording.arm.joints.empty() || joints.cols() == 0 || !joints.allFinite()) {
    return usage;
  }
  for (const auto& angles : joints.rowwise()) {
    usage.joints.push_back({angles.minCoeff(), angles.maxCoeff(), covered(angles)});
  }
  const double whole = reach(recording.arm);
  const Eigen::Vector3d shoulder(0.0, 0.0, recording.arm.joints.front().d);
  usage.nearest = std::numeric_limits<double>::infinity();
  std::set<std::tuple<bool, bool, bool, bool>> places;
  std::set<std::tuple<int, int, int>> directions;
  std::map<int, ElbowSides> placements;
  Arm without_stylus = recording.arm;  // tips where the last joint's frame is
  for (Probe& probe : without_stylus.probes) {
    probe.tip_in_last.setZero();
  }
  for (Eigen::Index i = 0; i < joints.cols(); ++i) {
    const Reading& reading = recording.readings[static_cast<std::size_t>(i)];
    const Eigen::VectorXd q = joints.col(i);
    const Eigen::Vector3d tip_in_base = tip_at(recording.arm, reading.probe, q);
    const Eigen::Vector3d from_shoulder = tip_in_base - shoulder;
    const double distance = from_shoulder.norm() / whole;
    usage.nearest = std::min(usage.nearest, distance);
    usage.farthest = std::max(usage.farthest, distance);
    places.insert({from_shoulder.x() > 0.0, from_shoulder.y() > 0.0, from_shoulder.z() > 0.0, distance > shell});
    const double length = recording.arm.probes[static_cast<std::size_t>(reading.probe)].tip_in_last.norm();
    if (length > 0.0) {
      directions.insert(nearest_direction((tip_in_base - tip_at(without_stylus, reading.probe, q)) / length));
    }
    ElbowSides& sides = placements[reading.placement];
    const Elbow elbow = elbow_side(recording.arm, reading.probe, q);
    sides.left += elbow == Elbow::Left ? 1 : 0;
    sides.right += elbow == Elbow::Right ? 1 : 0;
  }
  usage.volume_share = static_cast<double>(places.size()) / volume_cells;
  usage.orientation_share = static_cast<double>(directions.size()) / 26.0;
  for (const auto& [placement, sides] : placements) {
    const bool left = sides.on(sides.left);
    const bool right = sides.on(sides.right);
    usage.placements_both += left && right ? 1 : 0;
    usage.placements_left += left && !right ? 1 : 0;
    usage.placements_right += right && !left ? 1 : 0;
  }
  return usage;
}

Findings find_one_sided_placements(const Recording& recording, const Usage& usage) {
  const int one_sided = usage.placements_left + usage.placements_right;
  if (one_sided == 0) {
    return {};
  }
  return {
      {FindingKind::ElbowOnOneSide, recording.readings.empty() ? "" : recording.where(0),
       fmt::format("{} of {} placements were read with the elbow on one side only ({} left, {} right); errors of the "
                   "inner joints show better where each placement is read on both sides",
                   one_sided, one_sided + usage.placements_both, usage.placements_left, usage.placements_right)}};
}

}  // namespace artcal
