#include "identification/consistent.h"

#include "artefacts/virtual_probing.h"

namespace artcal {

int make_consistent(System& system, const Recording& recording, const Arm& arm, const Unknowns& unknowns) {
  int left = 0;
  for (const auto& feature : system.constraints->features) {
    if (feature.location != Location::Unknown || feature.demand != Demand::Coincide) {
      continue;
    }
    const Eigen::Vector3d point_in_base = unknowns[feature.group].values.segment<3>(feature.offset);
    for (const int reading : feature.readings) {
      const auto q = reach_point(arm, system.probes[reading], point_in_base, recording.joints.col(reading));
      if (!q) {
        ++left;
        continue;
      }
      const std::size_t width = 2 * arm.joints.size();
      joint_sines({q->data(), arm.joints.size()},
                  {system.sines.data() + width * static_cast<std::size_t>(reading), width});
    }
  }
  return left;
}

}  // namespace artcal
