#include "acquisition/arm/exchange/urdf_text.h"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Geometry>

#include "acquisition/arm/exchange/joint_chain.h"
#include "acquisition/arm/parameters.h"
#include "core/toml/toml_text.h"
#include "core/units.h"

namespace artcal {
namespace {

Rigid turned(double angle, const Eigen::Vector3d& axis) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), Eigen::Vector3d::Zero()};
}
Rigid shifted(double x, double z) { return {Eigen::Matrix3d::Identity(), {x, 0.0, z}}; }

// Rx(α) Tx(a) Ry(β)
Rigid link_motion(const Joint& joint) {
  return turned(joint.alpha, Eigen::Vector3d::UnitX()) * shifted(joint.a, 0.0) *
         turned(joint.beta, Eigen::Vector3d::UnitY());
}

std::string in_xml(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      default: safe += c;
    }
  }
  return safe;
}

std::string origin_text(const Rigid& at) {
  const Eigen::Vector3d place = at.translation / units::metre;
  const Eigen::Vector3d turn = roll_pitch_yaw_of(at.rotation);
  const auto three = [](const Eigen::Vector3d& v) {
    return fmt::format("{} {} {}", toml_number(v.x()), toml_number(v.y()), toml_number(v.z()));
  };
  return fmt::format("    <origin xyz=\"{}\" rpy=\"{}\"/>\n", three(place), three(turn));
}

std::string urdf_joint_text(std::size_t number, const Joint& joint, const Rigid& origin) {
  const bool limited = joint.lowest && joint.highest;
  const char* type = joint.is_prismatic() ? "prismatic" : limited ? "revolute" : "continuous";
  std::string text = fmt::format(
      "  <joint name=\"joint_{0}\" type=\"{1}\">\n    <parent link=\"link_{2}\"/>\n    <child link=\"link_{0}\"/>\n{3} "
      "   "
      "<axis xyz=\"0 0 {4}\"/>\n",
      number, type, number - 1, origin_text(origin), joint.sign < 0.0 ? -1 : 1);
  if (limited) {
    const double unit = joint.is_prismatic() ? units::metre : 1.0;
    text += fmt::format("    <limit lower=\"{}\" upper=\"{}\" effort=\"0\" velocity=\"0\"/>\n",
                        toml_number(*joint.lowest / unit), toml_number(*joint.highest / unit));
  }
  return text + "  </joint>\n";
}

// What of the joint a URDF has no words for.
std::string inexpressible(const Arm& arm, std::size_t i) {
  std::set<std::string> names;
  for (const Parameter& parameter : all_parameters(arm)) {
    if (parameter.is_joint_error() && parameter.owner == static_cast<int>(i) && value(arm, parameter) != 0.0) {
      names.insert(parameter.name);
    }
  }
  if (arm.joints[i].mechanical_coupling != 0.0) {
    names.insert("mechanical_coupling");
  }
  if (arm.joints[i].is_prismatic() && !(arm.joints[i].lowest && arm.joints[i].highest)) {
    return fmt::format("joint {} is prismatic and its ends, `min` and `max`, are not stated, which a URDF demands",
                       i + 1);
  }
  return names.empty() ? ""
                       : fmt::format("joint {} has {}, which a URDF cannot express", i + 1, fmt::join(names, ", "));
}

}  // namespace

Expected<std::string> urdf_text(const Arm& arm, const Eigen::Matrix3d& last_from_tip) {
  std::string links = "  <link name=\"link_0\"/>\n";
  std::string joints;
  Rigid before;  // from the last joint's frame to the next one's
  const bool standard = arm.convention == Convention::Standard;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    if (const std::string why = inexpressible(arm, i); !why.empty()) {
      return bad_input(why);
    }
    const Joint& joint = arm.joints[i];
    if (!standard) {
      before = before * link_motion(joint);
    }
    joints += urdf_joint_text(i + 1, joint, before * turned(joint.theta, Eigen::Vector3d::UnitZ()));
    links += fmt::format("  <link name=\"link_{}\"/>\n", i + 1);
    before = shifted(0.0, joint.d);
    if (standard) {
      before = before * link_motion(joint);
    }
  }
  for (std::size_t k = 0; k < arm.probes.size(); ++k) {
    const std::string name = arm.probes.size() == 1 ? "tip" : fmt::format("tip_{}", k + 1);
    const Rigid tip{last_from_tip, arm.probes[k].tip_in_last};
    links += fmt::format("  <link name=\"{}\"/>  <!-- centre of the tip of the probe {} -->\n", name, k + 1);
    joints += fmt::format(
        "  <joint name=\"{0}_joint\" type=\"fixed\">\n    <parent link=\"link_{1}\"/>\n    <child link=\"{0}\"/>\n{2}  "
        "</joint>\n",
        name, arm.joints.size(), origin_text(before * tip));
  }
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<robot name=\"{}\">\n{}{}</robot>\n",
                     in_xml(arm.name), links, joints);
}

}  // namespace artcal
