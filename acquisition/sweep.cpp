#include "acquisition/sweep.h"

#include <array>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

namespace artcal {

/// The axes one joint turns or slides on, in the base frame.
struct Sweep::Frame {
  Eigen::Vector3d z, z_at;  // θ about z through z_at, d along z
  Eigen::Vector3d x, x_at;  // α about x through x_at, a along x
  Eigen::Vector3d y;        // β about y through x_at
};

namespace {

void put(double* derivative, int column, const Eigen::Vector3d& value) {
  if (column >= 0) {
    double* out = derivative + 3 * static_cast<std::ptrdiff_t>(column);
    out[0] = value.x();
    out[1] = value.y();
    out[2] = value.z();
  }
}

// In the middle of the hottest loop there is; a call would cost as much as the turn.
[[gnu::always_inline]] inline void turn(Eigen::Vector3d& first, Eigen::Vector3d& second, double sine, double cosine) {
  const Eigen::Vector3d turned = cosine * first + sine * second;
  second = cosine * second - sine * first;
  first = turned;
}

}  // namespace

void joint_sines(std::span<const double> q, std::span<double> sines) {
  assert(sines.size() == 2 * q.size());
  for (std::size_t i = 0; i < q.size(); ++i) {
    sines[2 * i] = std::sin(q[i]);
    sines[2 * i + 1] = std::cos(q[i]);
  }
}

Sweep::Sweep(const Arm& arm, const std::vector<Parameter>& parameters, int probe)
    : convention_(arm.convention),
      tip_in_last_(arm.probes[probe].tip_in_last),
      tip_radius_(arm.probes[probe].radius),
      columns_(static_cast<int>(parameters.size())) {
  assert(static_cast<int>(arm.joints.size()) <= max_joints);
  for (const Joint& joint : arm.joints) {
    links_.push_back({joint.a, joint.d, joint.sign, std::sin(joint.theta), std::cos(joint.theta), std::sin(joint.alpha),
                      std::cos(joint.alpha), std::sin(joint.beta), std::cos(joint.beta),
                      joint.has_beta || joint.beta != 0.0, -1, -1, -1, -1, -1});
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

// Walks the chain outwards; `visit(i, frame)` sees the axes of joint i, `visit(n, last)` nothing more.
// Returns the tip; the last frame's axes are left in the closing call as x, y, z.
template <typename Visit>
Eigen::Vector3d Sweep::walk(JointSines sines, Visit&& visit) const {
  assert(sines.size() == 2 * links_.size());
  Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Frame frame;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const double sin_q = link.sign * sines[2 * i];
    const double cos_q = sines[2 * i + 1];
    const double sine = link.sin_theta * cos_q + link.cos_theta * sin_q;
    const double cosine = link.cos_theta * cos_q - link.sin_theta * sin_q;
    if (convention_ == Convention::Standard) {
      frame.z = z;
      frame.z_at = p;
      turn(x, y, sine, cosine);
      p += link.d * z + link.a * x;
      frame.x = x;
      frame.x_at = p;
      turn(y, z, link.sin_alpha, link.cos_alpha);
      frame.y = y;
      if (link.has_beta) {
        turn(z, x, link.sin_beta, link.cos_beta);
      }
    } else {
      frame.x = x;
      turn(y, z, link.sin_alpha, link.cos_alpha);
      p += link.a * x;
      frame.x_at = p;
      frame.y = y;
      if (link.has_beta) {
        turn(z, x, link.sin_beta, link.cos_beta);
      }
      frame.z = z;
      frame.z_at = p;
      turn(x, y, sine, cosine);
      p += link.d * z;
    }
    visit(i, frame);
  }
  visit(links_.size(), Frame{z, p, x, p, y});
  return p + tip_in_last_.x() * x + tip_in_last_.y() * y + tip_in_last_.z() * z;
}

Eigen::Vector3d Sweep::tip_in_base(JointSines sines) const {
  return walk(sines, [](std::size_t, const Frame&) {});
}

Eigen::Vector3d Sweep::tip_in_base(JointSines sines, double* derivative) const {
  std::array<Frame, max_joints + 1> frames;
  const Eigen::Vector3d tip = walk(sines, [&](std::size_t i, const Frame& frame) { frames[i] = frame; });
  Eigen::Map<Eigen::Matrix3Xd>(derivative, 3, columns_).setZero();
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

Eigen::Vector3d Sweep::tip_by_joints(JointSines sines, double* derivative) const {
  std::array<Frame, max_joints + 1> frames;
  const Eigen::Vector3d tip = walk(sines, [&](std::size_t i, const Frame& frame) { frames[i] = frame; });
  for (std::size_t i = 0; i < links_.size(); ++i) {
    put(derivative, static_cast<int>(i), links_[i].sign * frames[i].z.cross(tip - frames[i].z_at));
  }
  return tip;
}

Eigen::Vector3d Sweep::axes_in_base(JointSines sines, double* directions, double* points) const {
  return walk(sines, [&](std::size_t i, const Frame& frame) {
    if (i < links_.size()) {
      put(directions, static_cast<int>(i), frame.z);
      put(points, static_cast<int>(i), frame.z_at);
    }
  });
}

}  // namespace artcal
