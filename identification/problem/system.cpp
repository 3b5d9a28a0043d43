#include "identification/problem/system.h"

#include <cstring>

namespace artcal {
namespace {

// Those of the recording that this thread asked for last are kept: an identification makes a dozen systems of it.
std::vector<double> sines_of(const Eigen::MatrixXd& joints) {
  constexpr Eigen::Index max_kept = 1 << 20;  // more are not worth their memory
  const auto compute = [&] {
    std::vector<double> sines(2 * static_cast<std::size_t>(joints.size()));
    joint_sines({joints.data(), static_cast<std::size_t>(joints.size())}, sines);
    return sines;
  };
  if (joints.size() == 0 || joints.size() > max_kept) {
    return compute();
  }
  thread_local Eigen::MatrixXd of;
  thread_local std::vector<double> sines;
  if (of.rows() != joints.rows() || of.cols() != joints.cols() ||
      std::memcmp(of.data(), joints.data(), sizeof(double) * static_cast<std::size_t>(joints.size())) != 0) {
    sines = compute();
    of = joints;
  }
  return sines;
}

}  // namespace

const GroupState& state_of(const FeatureConstraint& feature, const Unknowns& unknowns) {
  static const GroupState none;
  return feature.group ? unknowns.groups[*feature.group] : none;
}

Arm System::arm_at(const double* x) const {
  Arm arm = start;
  for (std::size_t i = 0; i < free.size(); ++i) {
    set_value(arm, free[i], value(start, free[i]) + scale[static_cast<Eigen::Index>(i)] * x[i]);
  }
  return arm;
}

System make_system(const Recording& recording, const Constraints& constraints, const Arm& start,
                   std::vector<Parameter> free, double angle_scale) {
  System system;
  system.constraints = &constraints;
  system.start = start;
  system.free = std::move(free);
  system.scale.resize(system.arm_size());
  const double length = angle_scale > 0.0 ? angle_scale : reach(start);
  for (int i = 0; i < system.arm_size(); ++i) {
    system.scale[i] = physical_scale(system.free[i], length);
  }
  system.joints.assign(recording.joints.data(), recording.joints.data() + recording.joints.size());
  system.sines = sines_of(recording.joints);
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    system.probes.push_back(recording.readings[i].probe);
    system.temperatures.push_back(recording.readings[i].arm_temperature);
  }
  return system;
}

std::vector<ForwardKinematics> forward_kinematics_of(const System& system, const Arm& arm) {
  std::vector<ForwardKinematics> kinematics_by_probe;
  for (int probe = 0; probe < static_cast<int>(arm.probes.size()); ++probe) {
    kinematics_by_probe.emplace_back(arm, system.free, probe);
  }
  return kinematics_by_probe;
}

}  // namespace artcal
