#include "acquisition/arm/parallel_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "core/rigid.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double parallel_within = 5.0 * units::degree;

Eigen::Matrix3d turned_about(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

/// The five numbers between an axis and the next, wherever the convention keeps them.
struct Link {
  double &theta, &d, &a, &alpha, &beta;

  // Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β)
  [[nodiscard]] Rigid transform() const {
    const Eigen::Matrix3d turned = turned_about(theta, Eigen::Vector3d::UnitZ());
    return {turned * turned_about(alpha, Eigen::Vector3d::UnitX()) * turned_about(beta, Eigen::Vector3d::UnitY()),
            turned * Eigen::Vector3d(a, 0.0, d)};
  }
};

// The link that joins the axes, of a joint for which joins_parallel_axes(), and the joint on its far end.
Link link_of(Arm& arm, std::size_t joint) {
  const std::size_t near = arm.convention == Convention::Standard ? joint : joint - 1;
  Joint& carries = arm.joints[joint];
  return {arm.joints[near].theta, arm.joints[near].d, carries.a, carries.alpha, carries.beta};
}
Joint& far_joint(Arm& arm, std::size_t joint) {
  return arm.joints[arm.convention == Convention::Standard ? joint + 1 : joint];
}

// The same axes with the next frame's origin where the next axis passes through the plane d = 0.
void move_origin(Link link, Joint& next) {
  const Rigid before = link.transform();
  const Eigen::Vector3d direction = before.rotation.col(2);
  const double slide = -before.translation.z() / direction.z();
  const Eigen::Vector3d origin = before.translation + slide * direction;
  double angle = std::atan2(origin.y(), origin.x());
  double length = std::hypot(origin.x(), origin.y());
  if (std::abs(angle) > std::numbers::pi / 2) {  // the smaller turn, and a length below zero
    angle -= std::copysign(std::numbers::pi, angle);
    length = -length;
  }
  const Eigen::Vector3d in_link = turned_about(-angle, Eigen::Vector3d::UnitZ()) * direction;
  link.theta = angle;
  link.d = 0.0;
  link.a = length;
  link.alpha = std::atan2(-in_link.y(), in_link.z());
  link.beta = std::asin(std::clamp(in_link.x(), -1.0, 1.0));
  const Eigen::Matrix3d turn = before.rotation.transpose() * link.transform().rotation;
  next.theta -= std::atan2(turn(1, 0), turn(0, 0));
  next.d -= slide;
}

bool keeps_its_numbers(const Arm& arm) {
  return expands(arm) || std::any_of(arm.joints.begin(), arm.joints.end(), [](const Joint& joint) {
           return joint.errors.compliance != 0.0 || joint.is_prismatic();
         });
}

}  // namespace

bool joins_parallel_axes(const Arm& arm, std::size_t joint) {
  const bool standard = arm.convention == Convention::Standard;
  const bool joins = standard ? joint + 1 < arm.joints.size() : joint > 0;
  return joins && std::abs(std::sin(arm.joints[joint].alpha)) < std::sin(parallel_within);
}

std::string parallel_axes(const Arm& arm) {
  std::string text;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    if (!joins_parallel_axes(arm, i)) {
      continue;
    }
    // The link of a joint ends at the next axis; in modified DH it begins at the one before.
    const std::size_t first = arm.convention == Convention::Standard ? i + 1 : i;
    const double angle = std::abs(std::asin(std::sin(arm.joints[i].alpha))) / units::degree;
    text += fmt::format("{}axes {} and {} ({:.2g} deg)", text.empty() ? "" : ", ", first, first + 1, angle);
  }
  return text;
}

Arm with_hayati_angles(Arm arm) {
  const double longest = reach(arm);
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    if (!joins_parallel_axes(arm, i)) {
      continue;
    }
    arm.joints[i].has_beta = true;
    if (Link link = link_of(arm, i); std::abs(link.d) > longest && !keeps_its_numbers(arm)) {
      move_origin(link, far_joint(arm, i));
    }
  }
  return arm;
}

}  // namespace artcal
