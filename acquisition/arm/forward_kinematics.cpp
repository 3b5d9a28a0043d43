#include "acquisition/arm/forward_kinematics.h"

#include <algorithm>
#include <cmath>

#include "acquisition/arm/chain_walk.h"
#include "acquisition/arm/joint_error_kinematics.h"

namespace artcal {
namespace {

bool has_errors(const JointErrors& errors) {
  return errors.cosine != std::array<double, 2>{} || errors.sine != std::array<double, 2>{} || errors.gain != 0.0 ||
         errors.coupling != 0.0 || errors.compliance != 0.0 || errors.expansion != 0.0;
}

bool asks_for_errors(const std::vector<Parameter>& parameters) {
  return std::any_of(parameters.begin(), parameters.end(),
                     [](const Parameter& parameter) { return parameter.is_joint_error(); });
}

}  // namespace

void joint_sines(std::span<const double> q, std::span<double> sines) {
  assert(sines.size() == 2 * q.size());
  for (std::size_t i = 0; i < q.size(); ++i) {
#if defined(__GLIBC__)
    ::sincos(q[i], &sines[2 * i], &sines[2 * i + 1]);  // the bits of sin and cos in half of the time
#else
    sines[2 * i] = std::sin(q[i]);
    sines[2 * i + 1] = std::cos(q[i]);
#endif
  }
}

ForwardKinematics::ForwardKinematics(const Arm& arm, const std::vector<Parameter>& parameters, int probe)
    : convention_(arm.convention),
      reference_temperature_(arm.reference_temperature),
      tip_in_last_(arm.probes[probe].tip_in_last),
      tip_radius_(arm.probes[probe].radius),
      columns_(static_cast<int>(parameters.size())) {
  assert(static_cast<int>(arm.joints.size()) <= max_joints);
  bool errors = asks_for_errors(parameters);
  for (const Joint& joint : arm.joints) {
    links_.push_back({joint.a, joint.d, joint.sign, std::sin(joint.theta), std::cos(joint.theta), std::sin(joint.alpha),
                      std::cos(joint.alpha), std::sin(joint.beta), std::cos(joint.beta),
                      joint.has_beta || joint.beta != 0.0, joint.is_prismatic(), -1, -1, -1, -1, -1});
    errors = errors || joint.mechanical_coupling != 0.0 || artcal::has_errors(joint.errors);
  }
  for (std::size_t i = 0; errors && i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    errors_.push_back({joint.errors, joint.mass.value_or(0.0) * arm.gravity_in_base, {}});
    errors_.back().size.coupling += joint.mechanical_coupling;
    errors_.back().columns.fill(-1);
    sags_ = sags_ || joint.errors.compliance != 0.0;
  }
  for (int column = 0; column < columns_; ++column) {
    const Parameter& parameter = parameters[column];
    if (parameter.is_tip()) {
      if (parameter.owner == probe) {
        column_tip_[static_cast<int>(parameter.kind) - static_cast<int>(ParameterKind::TipX)] = column;
      }
      continue;
    }
    if (parameter.kind == ParameterKind::Radius) {
      column_radius_ = parameter.owner == probe ? column : column_radius_;
      continue;
    }
    if (parameter.is_joint_error()) {
      const int kind = static_cast<int>(parameter.kind) - static_cast<int>(ParameterKind::Cosine1);
      errors_[parameter.owner].columns[kind] = column;
      sags_ = sags_ || parameter.kind == ParameterKind::Compliance;
      continue;
    }
    Link& link = links_[parameter.owner];
    switch (parameter.kind) {
      case ParameterKind::A: link.column_a = column; break;
      case ParameterKind::D: link.column_d = column; break;
      case ParameterKind::Theta: link.column_theta = column; break;
      case ParameterKind::Alpha: link.column_alpha = column; break;
      default: link.column_beta = column; break;
    }
  }
}

Eigen::Vector3d ForwardKinematics::tip_in_base(const JointReading& reading) const {
  assert(reading.sines.size() == 2 * links_.size());
  const auto nothing = [](std::size_t, const Frame&) {};
  if (has_errors()) {
    const Posture posture = posture_of(reading);
    return walk(posture.sines.data(), posture.travels.data(), posture.grown(), nothing);
  }
  return walk(reading.sines.data(), reading.q.data(), NoExpansion(), nothing);
}

Eigen::Vector3d ForwardKinematics::tip_in_base(const JointReading& reading, double* derivative) const {
  assert(reading.sines.size() == 2 * links_.size());
  Eigen::Map<Eigen::Matrix3Xd>(derivative, 3, columns_).setZero();
  if (has_errors()) {
    return put_with_errors(reading, derivative);
  }
  std::array<Frame, max_joints + 1> frames;
  const Eigen::Vector3d tip = walk(reading.sines.data(), reading.q.data(), NoExpansion(),
                                   [&](std::size_t i, const Frame& frame) { frames[i] = frame; });
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const Frame& frame = frames[i];
    put(derivative, link.column_a, frame.x);
    put(derivative, link.column_d, frame.z);
    put(derivative, link.column_theta, frame.z.cross(tip - frame.z_at));
    put(derivative, link.column_alpha, frame.x.cross(tip - frame.x_at));
    if (link.has_beta) {
      put(derivative, link.column_beta, frame.y.cross(tip - frame.x_at));
    }
  }
  const Frame& last = frames[links_.size()];
  put(derivative, column_tip_[0], last.x);
  put(derivative, column_tip_[1], last.y);
  put(derivative, column_tip_[2], last.z);
  return tip;
}

void ForwardKinematics::tips_in_base(std::span<const JointReading> readings, double* tips, double* derivative) const {
  static_assert(max_links >= max_joints);
  assert(readings.size() <= postures_at_once);
  constexpr std::size_t few = 2;  // are done one by one as fast
  if (has_errors() || readings.size() <= few) {
    std::vector<double> own(derivative != nullptr ? static_cast<std::size_t>(3 * columns_) : 0);
    for (std::size_t i = 0; i < readings.size(); ++i) {
      const Eigen::Vector3d tip =
          derivative != nullptr ? tip_in_base(readings[i], own.data()) : tip_in_base(readings[i]);
      for (int k = 0; k < 3; ++k) {
        tips[k * postures_at_once + static_cast<int>(i)] = tip[k];
      }
      for (std::size_t k = 0; k < own.size(); ++k) {
        derivative[k * postures_at_once + i] = own[k];
      }
    }
    return;
  }
  alignas(64) double sines[2 * max_joints * postures_at_once];
  alignas(64) double q[max_joints * postures_at_once];
  const std::size_t joints = links_.size();
  for (std::size_t i = 0; i < postures_at_once; ++i) {
    const JointReading& reading = readings[std::min(i, readings.size() - 1)];  // lanes that nobody reads
    for (std::size_t k = 0; k < 2 * joints; ++k) {
      sines[k * postures_at_once + i] = reading.sines[k];
    }
    for (std::size_t k = 0; k < joints; ++k) {
      assert(!links_[k].is_prismatic || !reading.q.empty());
      q[k * postures_at_once + i] = links_[k].is_prismatic ? reading.q[k] : 0.0;
    }
  }
  const Chain chain{convention_ == Convention::Modified,
                    static_cast<int>(joints),
                    links_.data(),
                    {tip_in_last_.x(), tip_in_last_.y(), tip_in_last_.z()},
                    {column_tip_[0], column_tip_[1], column_tip_[2]},
                    columns_};
  chain_variants().back().pass(chain, sines, q, tips, derivative);
}

Eigen::Vector3d ForwardKinematics::tip_by_joints(const JointReading& reading, double* derivative) const {
  assert(reading.sines.size() == 2 * links_.size());
  if (has_errors()) {
    return put_by_joints_with_errors(reading, derivative);
  }
  std::array<Frame, max_joints + 1> frames;
  const Eigen::Vector3d tip = walk(reading.sines.data(), reading.q.data(), NoExpansion(),
                                   [&](std::size_t i, const Frame& frame) { frames[i] = frame; });
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Frame& frame = frames[i];
    const Eigen::Vector3d motion = links_[i].is_prismatic ? frame.z : frame.z.cross(tip - frame.z_at);
    put(derivative, static_cast<int>(i), links_[i].sign * motion);
  }
  return tip;
}

Eigen::Vector3d ForwardKinematics::axes_in_base(const JointReading& reading, double* directions, double* points) const {
  assert(reading.sines.size() == 2 * links_.size());
  const auto note = [&](std::size_t i, const Frame& frame) {
    if (i < links_.size()) {
      put(directions, static_cast<int>(i), frame.z);
      put(points, static_cast<int>(i), frame.z_at);
    }
  };
  if (has_errors()) {
    const Posture posture = posture_of(reading);
    return walk(posture.sines.data(), posture.travels.data(), posture.grown(), note);
  }
  return walk(reading.sines.data(), reading.q.data(), NoExpansion(), note);
}

}  // namespace artcal
