#pragma once

#include <array>
#include <cassert>
#include <cstddef>

#include <Eigen/Geometry>

#include "acquisition/arm/forward_kinematics.h"

/// The insides of the pass that its source files share.
namespace artcal {

/// The axes one joint turns or slides on, in the base frame.
struct ForwardKinematics::Frame {
  Eigen::Vector3d z, z_at;  // θ about z through z_at, d along z
  Eigen::Vector3d x, x_at;  // α about x through x_at, a along x
  Eigen::Vector3d y;        // β about y through x_at
};

/// Of all joints, and after them the last frame's axes.
struct ForwardKinematics::Frames {
  std::array<Frame, max_joints + 1> at;
};

inline void put(double* derivative, int column, const Eigen::Vector3d& value) {
  if (column >= 0) {
    double* out = derivative + 3 * static_cast<std::ptrdiff_t>(column);
    out[0] = value.x();
    out[1] = value.y();
    out[2] = value.z();
  }
}

// In the middle of the hottest loop there is; a call would cost as much as the turn, and g++ calls Eigen's assignments.
[[gnu::always_inline]] inline void turn(Eigen::Vector3d& first, Eigen::Vector3d& second, double sine, double cosine) {
  for (int i = 0; i < 3; ++i) {
    const double turned = cosine * first[i] + sine * second[i];
    second[i] = cosine * second[i] - sine * first[i];
    first[i] = turned;
  }
}

/// Links that stay as they are: no multiplication in the hottest loop.
struct NoExpansion {
  double operator()(std::size_t /*link*/, double length) const { return length; }
};

/// Walks the chain outwards; `visit(i, frame)` sees the axes of joint i, `visit(n, last)` the last frame's.
/// Returns the tip. `expansion_factor(i, length)` is how long a length of link i is. `q` is looked at where a joint is
/// prismatic.
template <typename ExpansionFactor, typename Visit>
[[gnu::always_inline]] inline Eigen::Vector3d ForwardKinematics::walk(const double* sines, const double* q,
                                                                      ExpansionFactor expansion_factor,
                                                                      Visit&& visit) const {
  Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Frame frame;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const double a = expansion_factor(i, link.a);
    double d = expansion_factor(i, link.d);
    double sin_q = link.sign * sines[2 * i];
    double cos_q = sines[2 * i + 1];
    if (link.is_prismatic) {
      assert(q != nullptr);
      d += link.sign * q[i];
      sin_q = 0.0;
      cos_q = 1.0;
    }
    const double sine = link.sin_theta * cos_q + link.cos_theta * sin_q;
    const double cosine = link.cos_theta * cos_q - link.sin_theta * sin_q;
    if (convention_ == Convention::Standard) {
      frame.z = z;
      frame.z_at = p;
      turn(x, y, sine, cosine);
      p += d * z + a * x;
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
      p += a * x;
      frame.x_at = p;
      frame.y = y;
      if (link.has_beta) {
        turn(z, x, link.sin_beta, link.cos_beta);
      }
      frame.z = z;
      frame.z_at = p;
      turn(x, y, sine, cosine);
      p += d * z;
    }
    visit(i, frame);
  }
  visit(links_.size(), Frame{z, p, x, p, y});
  const std::size_t last = links_.size() - 1;
  return p + (expansion_factor(last, tip_in_last_.x()) * x + expansion_factor(last, tip_in_last_.y()) * y +
              expansion_factor(last, tip_in_last_.z()) * z);
}

}  // namespace artcal
