#include "identification/problem/tips.h"

#include "identification/problem/posture_batch.h"

namespace artcal {
namespace {

// A tip on the last axis lies along it from the joint before; others roughly so. It tells sides, no more.
Eigen::Vector3d stylus_at(const ForwardKinematics& kinematics, const JointReading& reading, int joints) {
  Eigen::Matrix3Xd directions(3, joints);
  Eigen::Matrix3Xd points(3, joints);
  const Eigen::Vector3d tip = kinematics.axes_in_base(reading, directions.data(), points.data());
  return (tip - points.rightCols<1>()).normalized();
}

}  // namespace

double radius_of(const OnBall& ball, double expansion, const double* shared) {
  return ball.shared_radius ? expansion * shared[*ball.shared_radius] : ball.radius.value_or(0.0);
}

Tips tips_of(const System& system, const FeatureConstraint& feature,
             const std::vector<ForwardKinematics>& kinematics_by_probe) {
  Tips tips{&feature, Eigen::Matrix3Xd(3, feature.size()), Eigen::VectorXd(feature.size()), {}};
  const bool has_side = feature.is<OnPlane>() && feature.location == Location::Unknown;
  tips.styluses.resize(3, has_side ? feature.size() : 0);
  alignas(64) double at_once[3 * postures_at_once];
  for (int first = 0; first < feature.size();) {
    const PostureBatch taken = posture_batch(system, feature, first, feature.size());
    const ForwardKinematics& kinematics = kinematics_by_probe[system.probes[feature.readings[first]]];
    kinematics.tips_in_base({taken.readings.data(), static_cast<std::size_t>(taken.count)}, at_once, nullptr);
    for (int lane = 0; lane < taken.count; ++lane, ++first) {
      tips.centres.col(first) << at_once[lane], at_once[lane + postures_at_once], at_once[lane + 2 * postures_at_once];
      tips.radii[first] = kinematics.tip_radius();
      if (has_side) {
        tips.styluses.col(first) = stylus_at(kinematics, taken.readings[static_cast<std::size_t>(lane)],
                                             static_cast<int>(system.start.joints.size()));
      }
    }
  }
  return tips;
}

std::vector<Tips> all_tips(const System& system, const Arm& arm) {
  const auto kinematics_by_probe = forward_kinematics_of(system, arm);
  std::vector<Tips> tips;
  for (const FeatureConstraint& feature : system.constraints->features) {
    tips.push_back(tips_of(system, feature, kinematics_by_probe));
  }
  return tips;
}

Eigen::VectorXd distances_from_centre(const Tips& tips, const Eigen::VectorXd& shared) {
  const FeatureConstraint& feature = *tips.feature;
  if (const auto* lengths = feature.as<AtDistance>()) {
    return Eigen::VectorXd::Map(lengths->distances.data(), feature.size());
  }
  return tips.radii.array() + radius_of(std::get<OnBall>(feature.kind), feature.expansion, shared.data());
}

}  // namespace artcal
