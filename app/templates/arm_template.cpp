#include "app/templates/arm_template.h"

#include <fmt/format.h>

#include "acquisition/arm/arm.h"
#include "app/templates/answers.h"
#include "core/toml/toml_text.h"
#include "core/unit_names.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr const char* arm_head =
    R"(# A nominal arm to start from: the start of an identification. The numbers are an example after a published arm (Gao, Lu,
# Yang 2013); put those of your arm in their places. Every key is described in docs/files.md, "arm.toml".
schema = "artcal-arm/1"
name = {name}

# "standard" (Denavit, Hartenberg), or "modified" (Craig): there a and alpha of a joint are those of the link before it.
convention = {convention}

# Of the bare numbers in this file. Lengths: mm, um, m, in. Angles: deg, rad, mrad, arcsec.
units = {{ length = {length}, angle = {angle} }}

# The joints from the base to the wrist.
#   a, alpha   length across to the next axis, and the angle between the axes
#   d          length along this axis
#   theta      what is added to the reading of the joint: the offset of its encoder's zero
#   sign = -1             where the encoder counts against the axis
#   min = -170, max = 170 what the encoder reads at the ends of the travel
#   type = "prismatic"    a rail or column: its reading, min and max are lengths
#   beta = 0              Hayati's angle, where neighbouring axes are nearly parallel; d is 0 there
)";

constexpr const char* arm_foot = R"(
# The tip. Its centre lies on the last axis at the height l, or else at lx, ly, lz in the last joint's frame.
[[probe]]
name = "ball"
l = {l}
radius = {radius}
)";

// A shoulder, an elbow and a wrist of two joints each, for other numbers of joints continued likewise.
double example_d(int joint, int joints) {
  return joint + 1 == joints ? 0.0 : joint == 0 ? 300.0 : joint + 2 == joints ? 883.2 : joint % 2 == 1 ? 65.5 : 792.7;
}

}  // namespace

std::vector<Choice> ArmTemplate::choices() {
  return {{"--name", "NAME", "name of the arm", &name, {}, is_name, "a name"},
          {"--joints",
           "N",
           "number of joints",
           &joints,
           {},
           [](const std::string& n) { return is_count(n, 1, max_joints); },
           fmt::format("a number from 1 to {}", max_joints),
           1,
           static_cast<int>(max_joints)},
          {"--convention", "", "convention of the parameters", &convention, {"standard", "modified"}, nullptr, ""},
          {"--length-unit", "", "unit of lengths", &length_unit, length_unit_names(), nullptr, ""},
          {"--angle-unit", "", "unit of angles", &angle_unit, angle_unit_names(), nullptr, ""},
          {"--tip-radius",
           "TEXT",
           "radius of the tip's ball, with its unit",
           &tip_radius,
           {},
           is_length,
           "a length with its unit, such as \"3 mm\""}};
}

std::string ArmTemplate::text() const {
  const double mm = *artcal::length_unit(length_unit), rad = *artcal::angle_unit(angle_unit);
  std::string text = fmt::format(fmt::runtime(arm_head), fmt::arg("name", toml_text(name)),
                                 fmt::arg("convention", toml_text(convention)),
                                 fmt::arg("length", toml_text(length_unit)), fmt::arg("angle", toml_text(angle_unit)));
  const int count = std::stoi(joints);
  for (int i = 0; i < count; ++i) {
    const double alpha = convention == "modified" && i == 0 ? 0.0 : 90.0 * units::degree / rad;
    text += fmt::format("\n[[joint]]\na = 0\nd = {}\ntheta = 0\nalpha = {}\n", toml_number(example_d(i, count) / mm),
                        toml_number(alpha));
  }
  return text + fmt::format(fmt::runtime(arm_foot), fmt::arg("l", toml_number(183.5 / mm)),
                            fmt::arg("radius", toml_number(*length_quantity(tip_radius) / mm)));
}

}  // namespace artcal
