#include "acquisition/arm.h"

#include <algorithm>
#include <cmath>

namespace artcal {

double reach(const Arm& arm) {
  double length = 0.0;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    // The base column (d of the first joint; in modified DH also its a) carries the arm but does not swing.
    length += i == 0 && arm.convention == Convention::Modified ? 0.0 : std::abs(joint.a);
    length += i == 0 ? 0.0 : std::abs(joint.d);
  }
  double tip = 0.0;
  for (const Probe& probe : arm.probes) {
    tip = std::max(tip, probe.tip_in_last.norm());
  }
  return length + tip;
}

bool has_masses(const Arm& arm) {
  return std::all_of(arm.joints.begin(), arm.joints.end(), [](const Joint& joint) { return joint.mass.has_value(); });
}

bool expands(const Arm& arm) {
  return std::any_of(arm.joints.begin(), arm.joints.end(),
                     [](const Joint& joint) { return joint.errors.expansion != 0.0; });
}

int probe_index(const Arm& arm, const std::string& name) {
  const auto found =
      std::find_if(arm.probes.begin(), arm.probes.end(), [&](const Probe& probe) { return probe.name == name; });
  return found == arm.probes.end() ? -1 : static_cast<int>(found - arm.probes.begin());
}

}  // namespace artcal
