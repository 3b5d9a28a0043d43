#include "artefacts/simulation/posture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "acquisition/arm/forward_kinematics.h"
#include "artefacts/virtual_probing/postures.h"

namespace artcal {
namespace {

constexpr int max_starts = 200;       // of one posture
constexpr int starts_for_elbow = 16;  // then the side is given up: an arm that can do both misses it once in 65,000
constexpr int max_pushes = 5;         // off the stops, from one start

// Turns each reading by whole turns to where it is nearest to the middle of its range; whether all are
// then between the stops.
bool turn_into_stops(const VirtualArm& arm, const PostureRequest& request, Eigen::VectorXd& q) {
  constexpr double turn = 2.0 * std::numbers::pi;
  bool inside = true;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const VirtualJoint& joint = arm.joints[i];
    const double noise = request.encoder_noise.size() > 0 ? request.encoder_noise[i] : 0.0;
    const bool slides = arm.arm.joints[static_cast<std::size_t>(i)].is_prismatic();
    const double low = joint.low + (slides ? 0.0 : request.margin);
    const double high = joint.high - (slides ? 0.0 : request.margin);
    if (!slides && (q[i] + noise < low || q[i] + noise > high)) {
      q[i] += turn * std::round((0.5 * (low + high) - q[i]) / turn);
    }
    inside = inside && q[i] + noise >= low && q[i] + noise <= high;
  }
  return inside;
}

// Whether a reading a whole turn further on means the same posture: not where encoders gain, or turn with others by a
// part of a turn.
bool repeats_every_turn(const Arm& arm) {
  return std::all_of(arm.joints.begin(), arm.joints.end(), [](const Joint& joint) {
    return joint.is_prismatic() || (joint.errors.gain == 0.0 && joint.errors.coupling == 0.0 &&
                                    joint.mechanical_coupling == std::round(joint.mechanical_coupling));
  });
}

void push_off_stops(const VirtualArm& arm, const PostureRequest& request, Eigen::VectorXd& q) {
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const VirtualJoint& joint = arm.joints[i];
    const double range = joint.high - joint.low;
    const bool slides = arm.arm.joints[static_cast<std::size_t>(i)].is_prismatic();
    const double off = slides ? 0.05 * range : std::min(request.margin + 0.05, 0.25 * range);
    q[i] = std::clamp(q[i], joint.low + off, joint.high - off);
  }
}

// Further from the base than the arm is long, column included: no start would lead there.
bool is_beyond(const Arm& arm, const Eigen::Vector3d& target_in_base) {
  return !has_prismatic_joints(arm) &&
         !(target_in_base.norm() <= reach(arm) + std::abs(arm.joints.front().a) + std::abs(arm.joints.front().d));
}

}  // namespace

Elbow elbow_side(const Arm& arm, int probe, const Eigen::VectorXd& rigid_readings) {
  const Eigen::Index count = rigid_readings.size();
  std::vector<double> sines(2 * static_cast<std::size_t>(count));
  const std::span<const double> angles(rigid_readings.data(), static_cast<std::size_t>(count));
  joint_sines(angles, sines);
  Eigen::Matrix3Xd axes(3, count);
  Eigen::Matrix3Xd points(3, count);
  const Eigen::Vector3d tip =
      ForwardKinematics(arm, {}, probe).axes_in_base({sines, angles}, axes.data(), points.data());
  const Eigen::Vector3d left = axes.col(0).cross(tip - points.col(0)).normalized();
  double furthest = 0.0;
  for (Eigen::Index i = 1; i < count; ++i) {
    const double off = left.dot(points.col(i) - points.col(0));
    furthest = std::abs(off) > std::abs(furthest) ? off : furthest;
  }
  return !(std::abs(furthest) > 1e-3 * reach(arm)) ? Elbow::Either : furthest > 0.0 ? Elbow::Left : Elbow::Right;
}

Eigen::VectorXd random_readings(const VirtualArm& arm, RandomStream& random) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(arm.joints.size()));
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    q[i] = random.uniform(arm.joints[i].low, arm.joints[i].high);
  }
  return q;
}

std::optional<Eigen::VectorXd> find_posture_near(const VirtualArm& arm, const PostureRequest& request,
                                                 const Eigen::VectorXd& start) {
  Eigen::VectorXd from = start;
  for (int push = 0; push < max_pushes; ++push) {
    const auto rigid = reach_with_joints(arm.arm, request.probe, request.tip_in_base, from, request.arm_temperature);
    if (!rigid) {
      return std::nullopt;
    }
    const Eigen::VectorXd found = readings_of(arm, request.probe, *rigid);
    Eigen::VectorXd q = found;
    const bool inside = turn_into_stops(arm, request, q);
    if (inside && (q == found || repeats_every_turn(arm.arm))) {
      return q;
    }
    if (!inside) {
      push_off_stops(arm, request, q);
    }
    from = q;
  }
  return std::nullopt;
}

std::optional<Eigen::VectorXd> find_posture(const VirtualArm& arm, const PostureRequest& request,
                                            RandomStream& random) {
  std::optional<Eigen::VectorXd> other_side;
  if (is_beyond(arm.arm, request.tip_in_base)) {
    return std::nullopt;
  }
  for (int start = 0; start < max_starts && !(other_side && start >= starts_for_elbow); ++start) {
    const auto q = find_posture_near(arm, request, random_readings(arm, random));
    if (q && (request.elbow == Elbow::Either || elbow_side(arm.arm, request.probe, *q) == request.elbow)) {
      return q;
    }
    other_side = other_side ? other_side : q;
  }
  return other_side;
}

}  // namespace artcal
