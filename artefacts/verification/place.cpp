#include "artefacts/verification/place.h"

#include <cmath>

#include <fmt/format.h>

#include "core/units.h"

namespace artcal {
namespace {

constexpr double near_axis = 0.1;  // of the reach, off the first axis
constexpr double near_stop = 2.0 * units::degree;
constexpr double near_end = 1.0;  // mm, of a prismatic joint's travel

// Octants are counted about the shoulder, the height of the first joint's far end.
Eigen::Vector3d shoulder_in_base(const Arm& arm) { return {0.0, 0.0, arm.joints.empty() ? 0.0 : arm.joints.front().d}; }

int octant_of(const Eigen::Vector3d& from_shoulder) {
  const int quarter = from_shoulder.y() >= 0.0 ? (from_shoulder.x() >= 0.0 ? 1 : 2) : (from_shoulder.x() < 0.0 ? 3 : 4);
  return quarter + (from_shoulder.z() >= 0.0 ? 0 : 4);
}

int joint_at_stop(const Recording& recording, const Arm& arm, const std::vector<int>& readings) {
  for (std::size_t j = 0; j < arm.joints.size(); ++j) {
    const Joint& joint = arm.joints[j];
    for (const int i : readings) {
      const double q = recording.joints(static_cast<Eigen::Index>(j), i);
      const double near = joint.is_prismatic() ? near_end : near_stop;
      if ((joint.lowest && q < *joint.lowest + near) || (joint.highest && q > *joint.highest - near)) {
        return static_cast<int>(j) + 1;
      }
    }
  }
  return 0;
}

}  // namespace

Place place_of(const Eigen::Vector3d& point_in_base, const Recording& recording, const Arm& arm,
               const std::vector<int>& readings) {
  const Eigen::Vector3d from_shoulder = point_in_base - shoulder_in_base(arm);
  Place place;
  place.point_in_base = point_in_base;
  place.octant = octant_of(from_shoulder);
  if (!arm.joints.empty()) {
    const double whole = reach(arm);
    place.share_of_reach = from_shoulder.norm() / whole;
    place.above_base = from_shoulder.head<2>().norm() < near_axis * whole;
    place.joint_at_stop = joint_at_stop(recording, arm, readings);
  }
  return place;
}

std::string text_of(const Place& place) {
  std::string text = fmt::format("octant {}", place.octant);
  if (place.share_of_reach > 0.0) {
    text += fmt::format(", {:.0f} % of reach", 100.0 * place.share_of_reach);
  }
  if (place.above_base) {
    text += ", straight above the base";
  }
  if (place.joint_at_stop > 0) {
    text += fmt::format(", joint {} at its stop", place.joint_at_stop);
  }
  return text;
}

}  // namespace artcal
