#include "acquisition/arm/joint_error_keys.h"

#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/toml/toml_text.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double arcsecond_per_newton_metre = units::arcsecond / 1e3;  // rad/(N·mm)
constexpr double ppm = 1e-6;

/// An error of a joint in the file: two keys for it, what their numbers are to be multiplied by (0: the file's unit of
/// angles), and what is too large for a joint that works.
struct ErrorKey {
  double& (*of)(JointErrors& errors);
  const char* key;
  double unit;
  const char* field_key;
  double field_unit;
  double most;
  const char* field_name;
};

// In the order of ParameterKind. Beyond 0.01 rad (2063 arcsec) an encoder is broken, not eccentric.
const std::array<ErrorKey, 8> error_keys{{
    {[](JointErrors& e) -> double& { return e.cosine[0]; }, "cos_q", 0.0, "cos_q_arcsec", units::arcsecond, 0.01,
     "arcsec"},
    {[](JointErrors& e) -> double& { return e.sine[0]; }, "sin_q", 0.0, "sin_q_arcsec", units::arcsecond, 0.01,
     "arcsec"},
    {[](JointErrors& e) -> double& { return e.cosine[1]; }, "cos_2q", 0.0, "cos_2q_arcsec", units::arcsecond, 0.01,
     "arcsec"},
    {[](JointErrors& e) -> double& { return e.sine[1]; }, "sin_2q", 0.0, "sin_2q_arcsec", units::arcsecond, 0.01,
     "arcsec"},
    {[](JointErrors& e) -> double& { return e.gain; }, "gain", 1.0, "gain_ppm", ppm, 0.1, "ppm"},
    {[](JointErrors& e) -> double& { return e.coupling; }, "coupling", 1.0, "coupling_ppm", ppm, 0.1, "ppm"},
    {[](JointErrors& e) -> double& { return e.compliance; }, "compliance_rad_per_Nmm", 1.0, "compliance_arcsec_per_Nm",
     arcsecond_per_newton_metre, 1e4 * arcsecond_per_newton_metre, "arcsec/(N m)"},
    {[](JointErrors& e) -> double& { return e.expansion; }, "expansion_per_K", 1.0, "expansion_ppm_per_K", ppm, 1e-3,
     "ppm/K"},
}};

bool is_coupling(const ErrorKey& known) { return std::string_view(known.key) == "coupling"; }

bool is_whole_coupling(const ErrorKey& known, double number) { return is_coupling(known) && std::abs(number) == 1.0; }

}  // namespace

double most_of(ParameterKind joint_error) {
  return error_keys.at(static_cast<std::size_t>(joint_error) - static_cast<std::size_t>(ParameterKind::Cosine1)).most;
}

void read_joint_errors(TomlTable& table, double angle, Joint& joint) {
  for (const ErrorKey& known : error_keys) {
    const bool both = table.has(known.key) && table.has(known.field_key);
    const bool in_field_unit = table.has(known.field_key);
    const char* key = in_field_unit ? known.field_key : known.key;
    const double unit = in_field_unit ? known.field_unit : known.unit == 0.0 ? angle : known.unit;
    const double number = table.number_or(key, 0.0);
    if (is_whole_coupling(known, number * unit) && joint.mechanical_coupling == 0.0) {
      joint.mechanical_coupling = number * unit;  // no error of a gear is as large: a convention of the machine
      continue;
    }
    if (both) {
      table.fail(key, fmt::format("state either `{}` or `{}`, not both", known.key, known.field_key));
    } else if (is_coupling(known) && std::abs(number * unit) > known.most) {
      table.fail(key,
                 fmt::format("`{}` is {}, more than an error of a joint that works ({:.4g} {}). Where the joint is "
                             "stated against the ground instead of the link before it, state "
                             "`mechanical_coupling = {:g}`",
                             key, number, known.most / known.field_unit, known.field_name, number * unit));
    } else if (std::abs(number * unit) > known.most) {
      table.fail(key,
                 fmt::format("`{}` is {}, that is {:.4g} {}, expected at most {:.4g}; is its unit right?", key, number,
                             number * unit / known.field_unit, known.field_name, known.most / known.field_unit));
    }
    known.of(joint.errors) = number * unit;
  }
  joint.mass = table.optional_number("mass_kg");
  if (joint.mass && !(*joint.mass >= 0.0 && *joint.mass <= 1e3)) {
    table.fail("mass_kg", fmt::format("the mass of a link is {} kg, expected 0 to 1000", *joint.mass));
  }
}

std::string joint_errors_text(const Joint& joint) {
  std::string text;
  JointErrors errors = joint.errors;
  for (const ErrorKey& known : error_keys) {
    if (const double size = known.of(errors); size != 0.0) {
      text += fmt::format("{} = {}  # {:.6g} {}\n", known.key, toml_number(size), size / known.field_unit,
                          known.field_name);
    }
  }
  return joint.mass ? text + fmt::format("mass_kg = {}\n", toml_number(*joint.mass)) : text;
}

void read_gravity(TomlTable& root, Arm& arm) {
  if (root.has("gravity_m_s2")) {
    const auto numbers = root.numbers("gravity_m_s2");
    const Eigen::Vector3d gravity =
        numbers.size() == 3 ? Eigen::Vector3d::Map(numbers.data()) : Eigen::Vector3d::Zero().eval();
    if (!(gravity.norm() > 9.0 && gravity.norm() < 11.0)) {
      root.fail("gravity_m_s2",
                "`gravity_m_s2` is no gravity, expected its three components in the base frame in m/s², such as "
                "[0, 0, -9.81]");
    } else {
      arm.gravity_in_base = gravity;
    }
  }
}

void read_surroundings(TomlTable& root, Arm& arm) {
  read_gravity(root, arm);
  arm.reference_temperature = root.number_or("reference_temperature_C", arm.reference_temperature);
  if (!(arm.reference_temperature > -100.0 && arm.reference_temperature < 200.0)) {
    root.fail("reference_temperature_C",
              fmt::format("the reference temperature is {}, expected degC", arm.reference_temperature));
  }
}

std::string surroundings_text(const Arm& arm) {
  const Arm usual;
  std::string text;
  if (arm.gravity_in_base != usual.gravity_in_base) {
    const Eigen::Vector3d& g = arm.gravity_in_base;
    text += fmt::format("gravity_m_s2 = [{}, {}, {}]\n", toml_number(g.x()), toml_number(g.y()), toml_number(g.z()));
  }
  if (expands(arm) || arm.reference_temperature != usual.reference_temperature) {
    text += fmt::format("reference_temperature_C = {}\n", toml_number(arm.reference_temperature));
  }
  return text;
}

}  // namespace artcal
