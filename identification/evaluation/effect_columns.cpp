#include "identification/evaluation/effect_columns.h"

#include <cmath>

#include <Eigen/Geometry>

namespace artcal {
namespace {

constexpr double least_range = 0.2;  // K: temperatures that vary by less tell nothing

}  // namespace

EffectColumns::EffectColumns(const System& system, const Recording& recording)
    : system_(system), recording_(recording) {
  double lowest = INFINITY;
  double highest = -INFINITY;
  double sum = 0.0;
  bool all_read = !recording.readings.empty();
  for (const Reading& reading : recording.readings) {
    all_read = all_read && std::isfinite(reading.temperature);
    lowest = std::min(lowest, reading.temperature);
    highest = std::max(highest, reading.temperature);
    sum += reading.temperature;
  }
  temperature_varies_ = all_read && highest - lowest > least_range;
  mean_temperature_ = temperature_varies_ ? sum / static_cast<double>(recording.readings.size()) : 0.0;
  const auto add = [&](Effect effect, int joint, int columns) {
    families_.push_back({effect, joint, size_, columns});
    size_ += columns;
  };
  const auto joints = static_cast<int>(system.start.joints.size());
  for (int joint = 0; joint < joints; ++joint) {
    if (system.start.joints[static_cast<std::size_t>(joint)].is_prismatic()) {
      continue;  // nothing about it turns
    }
    add(Effect::OncePerTurn, joint, 2);
    add(Effect::TwicePerTurn, joint, 2);
    add(Effect::Gain, joint, 1);
    add(Effect::Gravity, joint, joints - joint);
    add(Effect::Drift, joint, 1);
    if (temperature_varies_) {
      add(Effect::TemperatureOffset, joint, 1);
    }
  }
  if (temperature_varies_) {
    add(Effect::Expansion, 0, 1);
  }
}

Eigen::Vector3d EffectColumns::at(int reading, const ForwardKinematics& kinematics, Eigen::Ref<Eigen::Matrix3Xd> tips,
                                  Eigen::Ref<Eigen::VectorXd> rotations) const {
  const int joints = kinematics.joint_count();
  using OfJoints = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, max_joints>;
  OfJoints by_joint(3, joints);
  OfJoints axes(3, joints);
  OfJoints points(3, joints);
  const Eigen::Vector3d tip = kinematics.tip_by_joints(system_.sines_of(reading), by_joint.data());
  kinematics.axes_in_base(system_.sines_of(reading), axes.data(), points.data());
  const Eigen::Vector3d down = system_.start.gravity_in_base.normalized();
  const double place = 2.0 * reading / std::max(1.0, static_cast<double>(recording_.readings.size()) - 1.0) - 1.0;
  const double temperature_offset =
      temperature_varies_ ? recording_.readings[reading].temperature - mean_temperature_ : 0.0;
  for (const EffectFamily& family : families_) {
    const double q = recording_.joints(family.joint, reading);
    auto out = rotations.segment(family.first, family.columns);
    switch (family.effect) {
      case Effect::OncePerTurn: out << std::sin(q), std::cos(q); break;
      case Effect::TwicePerTurn: out << std::sin(2.0 * q), std::cos(2.0 * q); break;
      case Effect::Gain: out << q; break;
      case Effect::Drift: out << place; break;
      case Effect::TemperatureOffset: out << temperature_offset; break;
      case Effect::Gravity:
        // The weight of each link further out, in the middle between its axis and the next, by its lever in m.
        for (int link = family.joint; link < joints; ++link) {
          const Eigen::Vector3d end = link + 1 < joints ? Eigen::Vector3d(points.col(link + 1)) : tip;
          const Eigen::Vector3d lever = 0.5 * (points.col(link) + end) - points.col(family.joint);
          out[link - family.joint] =
              system_.start.joints[family.joint].sign * 1e-3 * axes.col(family.joint).dot(lever.cross(down));
        }
        break;
      case Effect::Expansion:
        tips.col(family.first) = temperature_offset * tip;
        out.setZero();
        continue;
    }
    for (int i = 0; i < family.columns; ++i) {
      tips.col(family.first + i) = by_joint.col(family.joint) * out[i];
    }
  }
  return tip;
}

}  // namespace artcal
