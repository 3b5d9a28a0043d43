#include "app/results/identification/readings_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "acquisition/arm/forward_kinematics.h"
#include "app/output/json_list.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json column_json(const std::vector<Eigen::Vector3d>& vectors, int axis) {
  Json column = Json::array();
  for (const Eigen::Vector3d& vector : vectors) {
    column.push_back(vector[axis]);
  }
  return column;
}

Json columns_json(const std::vector<Eigen::Vector3d>& vectors) {
  return {column_json(vectors, 0), column_json(vectors, 1), column_json(vectors, 2)};
}

// Along each joint's axis by d, then to the next one.
Json path_of(const Arm& arm, const Eigen::VectorXd& q, int probe) {
  const int joints = static_cast<int>(arm.joints.size());
  const ForwardKinematics kinematics(arm, {}, probe);
  std::vector<double> sines(2 * joints);
  const std::span<const double> angles(q.data(), static_cast<std::size_t>(q.size()));
  joint_sines(angles, sines);
  Eigen::Matrix3Xd directions(3, joints), points(3, joints);
  const Eigen::Vector3d tip = kinematics.axes_in_base({sines, angles}, directions.data(), points.data());
  Json path = Json::array();
  for (int i = 0; i < joints; ++i) {
    const Eigen::Vector3d begin = points.col(i);
    path.push_back(point_json(begin));
    const Joint& joint = arm.joints[static_cast<std::size_t>(i)];
    const double travel = joint.is_prismatic() ? joint.sign * q[i] : 0.0;
    path.push_back(point_json(begin + (joint.d + travel) * directions.col(i)));
  }
  path.push_back(point_json(tip));
  return path;
}

}  // namespace

Json residuals_json(const Recording& recording, const Constraints& constraints, const Identification& result) {
  Json readings = Json::array(), features = Json::array();
  for (std::size_t feature = 0; feature < constraints.features.size(); ++feature) {
    for (const int reading : constraints.features[feature].readings) {
      readings.push_back(reading);
      features.push_back(feature);
    }
  }
  Json joints = Json::array();
  for (Eigen::Index joint = 0; joint < recording.joints.rows(); ++joint) {
    Json angles = Json::array();
    for (const auto& feature : constraints.features) {
      for (const int reading : feature.readings) {
        angles.push_back(recording.joints(joint, reading));
      }
    }
    joints.push_back(std::move(angles));
  }
  Json prismatic = Json::array();
  for (std::size_t joint = 0; joint < recording.arm.joints.size(); ++joint) {
    if (recording.arm.joints[joint].is_prismatic()) {
      prismatic.push_back(joint + 1);
    }
  }
  return {{"reading", std::move(readings)},
          {"feature", std::move(features)},
          {"joints_rad", std::move(joints)},
          {"prismatic_joints", std::move(prismatic)},
          {"before_mm", result.before.deviations},
          {"after_mm", result.after.deviations},
          {"tip_mm", columns_json(result.after.tips)},
          {"offset_mm", columns_json(result.after.offsets)}};
}

Json arm_shape_json(const Recording& recording, const Arm& arm) {
  const int count = static_cast<int>(recording.readings.size());
  const int rows = static_cast<int>(recording.joints.rows());
  if (count == 0 || rows == 0 || rows != static_cast<int>(arm.joints.size())) {
    return nullptr;
  }
  const int reading = count / 2;
  const Eigen::VectorXd q = recording.joints.col(reading);
  const std::string& probe = recording.arm.probes[recording.readings[reading].probe].name;
  const int index = probe_index(arm, probe);
  if (!q.allFinite() || index < 0) {
    return nullptr;
  }
  return {{"reading", reading}, {"path_mm", path_of(arm, q, index)}};
}

Json temperature_json(const Recording& recording) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const Reading& reading : recording.readings) {
    if (std::isfinite(reading.temperature)) {
      lowest = std::min(lowest, reading.temperature);
      highest = std::max(highest, reading.temperature);
    }
  }
  return lowest <= highest ? Json{{"lowest_C", lowest}, {"highest_C", highest}} : Json(nullptr);
}

}  // namespace artcal
