#include "acquisition/arm/exchange/joint_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double parallel_to = 5.0 * units::degree;
constexpr double same_axis = 1e-12;   // of a unit vector
constexpr double same_place = 1e-10;  // mm
constexpr double farthest = 1e7;      // mm

Eigen::Matrix3d about(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

/// An axis of the chain at a reading of zero, in its base frame.
struct ChainAxis {
  const ChainJoint* joint = nullptr;
  Eigen::Vector3d direction, point;
};

struct ChainAxes {
  std::vector<ChainAxis> moving;
  Rigid base_from_tip;
};

ChainAxes axes_of(const JointChain& chain) {
  ChainAxes axes;
  Rigid base_from_joint;
  for (const ChainJoint& joint : chain.joints) {
    base_from_joint = base_from_joint * joint.parent_from_joint;
    if (!joint.is_fixed) {
      axes.moving.push_back(
          {&joint, (base_from_joint.rotation * joint.axis_in_joint).normalized(), base_from_joint.translation});
    }
  }
  axes.base_from_tip = base_from_joint;
  return axes;
}

// The frame whose z axis is the line, the direction nearest to the chain's own axes otherwise.
Rigid frame_on(const ChainAxis& axis) {
  Rigid frame;
  const Eigen::Vector3d& z = axis.direction;
  const Eigen::Vector3d across = std::abs(z.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  frame.rotation.col(2) = z;
  frame.rotation.col(0) = (across - across.dot(z) * z).normalized();
  frame.rotation.col(1) = z.cross(frame.rotation.col(0));
  frame.translation = axis.point;
  return frame;
}

bool is_z_of_base(const ChainAxis& axis) {
  const bool through_origin = axis.joint->type == JointType::Prismatic || axis.point.head<2>().norm() <= same_place;
  return through_origin && axis.direction.head<2>().norm() <= same_axis;
}

// The link from a z axis to the next axis, both in the frame of the first: by the common normal, or where the axes are
// nearly parallel with Hayati's angle in the plane d = 0.
void put_link(const Eigen::Vector3d& direction, const Eigen::Vector3d& point, Joint& joint) {
  const Eigen::Vector3d across(-direction.y(), direction.x(), 0.0);  // z × direction
  const double sine = across.norm();
  if (sine < std::sin(parallel_to)) {
    const Eigen::Vector3d origin = point - point.z() / direction.z() * direction;
    joint.a = std::hypot(origin.x(), origin.y());
    joint.theta = joint.a > same_place ? std::atan2(origin.y(), origin.x()) : 0.0;
    const Eigen::Vector3d in_link = about(-joint.theta, Eigen::Vector3d::UnitZ()) * direction;
    joint.alpha = std::atan2(-in_link.y(), in_link.z());
    joint.beta = std::asin(std::clamp(in_link.x(), -1.0, 1.0));
    joint.has_beta = true;
    return;
  }
  const Eigen::Vector3d x = across / sine;
  joint.theta = std::atan2(x.y(), x.x());
  joint.a = x.dot(point);
  joint.alpha = std::atan2(sine, direction.z());
  // The foot of the common normal on the z axis: where the other line is nearest to it.
  joint.d = point.z() - direction.z() * (direction.head<2>().dot(point.head<2>())) / (sine * sine);
}

// x may point the other way: the smaller turn is what a person expects.
void prefer_small_turn(Joint& joint) {
  if (std::abs(joint.theta) <= 0.5 * std::numbers::pi + 1e-9) {
    return;
  }
  joint.theta -= std::copysign(std::numbers::pi, joint.theta);
  joint.a = -joint.a;
  joint.alpha = -joint.alpha;
  joint.beta = -joint.beta;
}

// Coordinates that are zero but for the arithmetic.
Eigen::Vector3d without_rounding(const Eigen::Vector3d& tip) {
  return (tip.array().abs() > 1e-12 * (1.0 + tip.norm())).select(tip, 0.0);
}

Rigid transform_of_link(const Joint& joint) {
  const Eigen::Matrix3d turned = about(joint.theta, Eigen::Vector3d::UnitZ());
  return {turned * about(joint.alpha, Eigen::Vector3d::UnitX()) * about(joint.beta, Eigen::Vector3d::UnitY()),
          turned * Eigen::Vector3d(joint.a, 0.0, joint.d)};
}

Error not_on_base_axis(const ChainAxis& axis) {
  return {
      ErrorCode::BadInput,
      fmt::format("the axis of joint {} is not the z axis of the base (its direction there is {:.6g}, {:.6g}, {:.6g}, "
                  "through {:.6g}, {:.6g}, {:.6g} mm), and an arm's file has no transform before its first joint; "
                  "--own-base lays the base on that axis, --base LINK takes another link for the base",
                  in_quotes(axis.joint->name), axis.direction.x(), axis.direction.y(), axis.direction.z(),
                  axis.point.x(), axis.point.y(), axis.point.z()),
      {}};
}

}  // namespace

Expected<ChainArm> arm_of_chain(const JointChain& chain, bool base_on_first_axis) {
  const ChainAxes axes = axes_of(chain);
  if (axes.moving.empty()) {
    return bad_input("no joint of the chain moves, and so it is no arm");
  }
  if (axes.moving.size() > max_joints) {
    return bad_input(fmt::format("{} joints of the chain move, expected at most {}: {} is one too many",
                                 axes.moving.size(), max_joints, in_quotes(axes.moving[max_joints].joint->name)));
  }
  for (const ChainJoint& joint : chain.joints) {
    if (!(joint.parent_from_joint.translation.norm() < farthest)) {
      return bad_input(fmt::format("joint {} is {:.3g} mm from the one before, farther than any arm is long",
                                   in_quotes(joint.name), joint.parent_from_joint.translation.norm()));
    }
  }
  ChainArm result;
  if (base_on_first_axis) {
    result.base_from_arm = frame_on(axes.moving.front());
  } else if (!is_z_of_base(axes.moving.front())) {
    return tl::unexpected(not_on_base_axis(axes.moving.front()));
  }
  Arm& arm = result.arm;
  arm.name = truncated(80, chain.name);
  Rigid base_from_link = result.base_from_arm;
  for (std::size_t i = 0; i < axes.moving.size(); ++i) {
    const ChainAxis& axis = axes.moving[i];
    Joint& joint = arm.joints.emplace_back();
    joint.type = axis.joint->type;
    joint.lowest = axis.joint->lowest;
    joint.highest = axis.joint->highest;
    joint.sign = base_from_link.rotation.col(2).dot(axis.direction) < 0.0 ? -1.0 : 1.0;
    const Rigid link_from_base = base_from_link.inverse();
    if (i + 1 == axes.moving.size()) {
      arm.probes.push_back(
          {truncated(80, chain.tip), without_rounding(link_from_base * axes.base_from_tip.translation), 0.0, false});
      result.last_from_tip = link_from_base.rotation * axes.base_from_tip.rotation;
      break;
    }
    const ChainAxis& next = axes.moving[i + 1];
    // A prismatic axis has a direction and no place.
    const Eigen::Vector3d point = next.joint->type == JointType::Prismatic ? base_from_link.translation : next.point;
    put_link(link_from_base.rotation * next.direction, link_from_base * point, joint);
    prefer_small_turn(joint);
    base_from_link = base_from_link * transform_of_link(joint);
  }
  return result;
}

Eigen::Matrix3d rotation_of_roll_pitch_yaw(const Eigen::Vector3d& roll_pitch_yaw) {
  return about(roll_pitch_yaw.z(), Eigen::Vector3d::UnitZ()) * about(roll_pitch_yaw.y(), Eigen::Vector3d::UnitY()) *
         about(roll_pitch_yaw.x(), Eigen::Vector3d::UnitX());
}

Eigen::Vector3d roll_pitch_yaw_of(const Eigen::Matrix3d& rotation) {
  const double yaw = std::atan2(rotation(1, 0), rotation(0, 0));
  const Eigen::Matrix3d without_yaw = about(-yaw, Eigen::Vector3d::UnitZ()) * rotation;
  const double pitch = std::atan2(-without_yaw(2, 0), without_yaw(0, 0));
  const Eigen::Matrix3d rest = about(-pitch, Eigen::Vector3d::UnitY()) * without_yaw;
  return {std::atan2(rest(2, 1), rest(1, 1)), pitch, yaw};
}

}  // namespace artcal
