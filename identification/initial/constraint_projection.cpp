#include "identification/initial/constraint_projection.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <Eigen/LU>

#include "artefacts/virtual_probing/postures.h"
#include "identification/least_squares/residual.h"

namespace artcal {
namespace {

// Where the constraint wants a tip: the nearest point that has no residual.
Eigen::Vector3d nearest(const FeatureResidual& residual, int reading, const ForwardKinematics& kinematics,
                        JointReading sines) {
  const Eigen::Vector3d tip = kinematics.tip_in_base(sines);
  const Residual r = residual.at(reading, tip, kinematics.tip_radius(), true);
  const Eigen::MatrixX3d slope = r.by_tip.topRows(r.rows);  // orthonormal rows
  return tip - slope.transpose() * r.value.head(r.rows);
}

}  // namespace

bool needs_moving(const FeatureConstraint& feature, const Constraints& constraints) {
  if (feature.is<OnPlane>() || (feature.is<Coincide>() && feature.location == Location::Unknown)) {
    return true;
  }
  // Beside a turn that is not among the unknowns, a motion of the base would turn the residuals.
  if (feature.group && constraints.groups[*feature.group].turn == PoseTurn::Unseen) {
    return true;
  }
  const auto radius = feature.shared_radius();
  return radius && constraints.shared[*radius].u == 0.0;
}

int project_onto_constraints(System& system, const Recording& recording, const Arm& arm, const Unknowns& unknowns) {
  const auto kinematics_by_probe = forward_kinematics_of(system, arm);
  const std::size_t width = arm.joints.size();
  std::vector<std::optional<ReachWithJoints>> reach_by_probe(arm.probes.size());
  int left = 0;
  for (const auto& feature : system.constraints->features) {
    if (!needs_moving(feature, *system.constraints)) {
      continue;
    }
    const GroupState& group = state_of(feature, unknowns);
    const FeatureResidual residual(feature, group.reference, group.values.data(), unknowns.shared.data());
    for (int k = 0; k < feature.size(); ++k) {
      const int reading = feature.readings[k];
      const Eigen::Vector3d target =
          nearest(residual, k, kinematics_by_probe[system.probes[reading]], system.sines_of(reading));
      auto& reach = reach_by_probe[static_cast<std::size_t>(system.probes[reading])];
      if (!reach) {
        reach.emplace(arm, system.probes[reading]);
      }
      const auto q =
          (*reach)(target, recording.joints.col(reading), system.temperatures[static_cast<std::size_t>(reading)]);
      if (!q) {
        ++left;
        continue;
      }
      const std::size_t first = width * static_cast<std::size_t>(reading);
      std::copy(q->begin(), q->end(), system.joints.data() + first);
      joint_sines({q->data(), width}, {system.sines.data() + 2 * first, 2 * width});
    }
  }
  return left;
}

}  // namespace artcal
