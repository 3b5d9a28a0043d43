#include "app/history/length_change.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "acquisition/arm/forward_kinematics.h"
#include "core/random.h"

namespace artcal {
namespace {

constexpr int length_count = 500;

std::vector<double> drawn_posture(const Arm& arm, RandomStream& random) {
  std::vector<double> q;
  for (const Joint& joint : arm.joints) {
    if (joint.is_prismatic()) {
      const double travel = 0.5 * reach(arm);
      const double low = joint.lowest.value_or(joint.highest.value_or(0.5 * travel) - travel);
      q.push_back(random.uniform(low, joint.highest.value_or(low + travel)));
      continue;
    }
    const double low = joint.lowest.value_or(joint.highest.value_or(std::numbers::pi) - 2.0 * std::numbers::pi);
    q.push_back(random.uniform(low, joint.highest.value_or(low + 2.0 * std::numbers::pi)));
  }
  return q;
}

Eigen::Vector3d tip(const ForwardKinematics& kinematics, const std::vector<double>& q) {
  std::vector<double> sines(2 * q.size());
  joint_sines(q, sines);
  return kinematics.tip_in_base({sines, q});
}

}  // namespace

std::optional<LengthChange> length_change(const Arm& then, const Arm& now) {
  if (then.joints.size() != now.joints.size()) {
    return std::nullopt;
  }
  const ForwardKinematics before(then, {}, 0), after(now, {}, 0);
  RandomStream random(1, "change of lengths");
  LengthChange change;
  double squares = 0.0;
  for (int i = 0; i < length_count; ++i) {
    const auto from = drawn_posture(then, random), to = drawn_posture(then, random);
    const double difference = (tip(after, to) - tip(after, from)).norm() - (tip(before, to) - tip(before, from)).norm();
    squares += difference * difference;
    change.maximum = std::max(change.maximum, std::abs(difference));
  }
  change.rms = std::sqrt(squares / length_count);
  return change;
}

}  // namespace artcal
