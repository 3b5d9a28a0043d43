// The arm in Python: made from a file or from arrays, its forward kinematics for many postures at once.
#include "python/native/arm.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/arm/forward_kinematics.h"
#include "acquisition/arm/parameters.h"
#include "core/text/in_quotes.h"
#include "python/native/errors.h"

namespace artcal::python {
namespace {

namespace py = pybind11;

// A C-contiguous array of double is used as it is; another one is copied.
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// An arm with what its file says of it.
struct PythonArm {
  Arm arm;
  std::optional<ArmIdentification> identification;
};

PythonArm from_file(const std::string& path) {
  auto file = value_or_raise(read_arm_file(path));
  return {std::move(file.arm), std::move(file.identification)};
}

void require_length(const char* name, const Array& values, py::ssize_t joints) {
  if (values.ndim() != 1 || values.shape(0) != joints) {
    raise(wrong_usage(fmt::format("{}: expected {} numbers, one a joint", name, joints)).value());
  }
}

PythonArm from_dh(const Array& a, const Array& d, const Array& theta, const Array& alpha, const Array& tip,
                  const std::string& convention, const std::optional<Array>& beta, const std::optional<Array>& sign,
                  double tip_radius, const std::string& name) {
  const py::ssize_t joints = a.ndim() == 1 ? a.shape(0) : 0;
  if (joints < 1 || joints > max_joints) {
    raise(wrong_usage(fmt::format("a: expected an array of 1 to {} numbers, one a joint", max_joints)).value());
  }
  for (const auto& [label, values] : {std::pair("d", &d), std::pair("theta", &theta), std::pair("alpha", &alpha)}) {
    require_length(label, *values, joints);
  }
  if (tip.ndim() != 1 || tip.shape(0) != 3) {
    raise(wrong_usage("tip: expected three numbers, x, y and z in the last joint's frame, mm").value());
  }
  if (convention != "standard" && convention != "modified") {
    raise(wrong_usage(fmt::format("convention is {}, expected standard or modified", in_quotes(convention))).value());
  }
  PythonArm made;
  made.arm.name = name;
  made.arm.convention = convention == "standard" ? Convention::Standard : Convention::Modified;
  for (py::ssize_t i = 0; i < joints; ++i) {
    Joint joint;
    joint.a = a.at(i);
    joint.d = d.at(i);
    joint.theta = theta.at(i);
    joint.alpha = alpha.at(i);
    if (beta) {
      require_length("beta", *beta, joints);
      joint.beta = beta->at(i);
      joint.has_beta = joint.beta != 0.0;
    }
    if (sign) {
      require_length("sign", *sign, joints);
      joint.sign = sign->at(i);
    }
    made.arm.joints.push_back(joint);
  }
  Probe probe;
  probe.tip_in_last = {tip.at(0), tip.at(1), tip.at(2)};
  probe.on_axis = tip.at(0) == 0.0 && tip.at(1) == 0.0;
  probe.radius = tip_radius;
  made.arm.probes.push_back(probe);
  return made;
}

int probe_of(const Arm& arm, const std::string& name) {
  const int probe = name.empty() ? 0 : probe_index(arm, name);
  if (probe < 0) {
    raise(wrong_usage(fmt::format("the arm has no probe {}", in_quotes(name))).value());
  }
  return probe;
}

/// Joint readings, one posture a row.
struct Postures {
  const double* first;
  py::ssize_t count, joints;
  double temperature;

  [[nodiscard]] std::span<const double> q(py::ssize_t i) const {
    return {first + i * joints, static_cast<std::size_t>(joints)};
  }
};

Postures postures_of(const Arm& arm, const Array& q, double temperature) {
  const auto joints = static_cast<py::ssize_t>(arm.joints.size());
  const bool one = q.ndim() == 1 && q.shape(0) == joints;
  if (!one && (q.ndim() != 2 || q.shape(1) != joints)) {
    raise(wrong_usage(fmt::format("q: expected an array of shape (postures, {}), rad", joints)).value());
  }
  return {q.data(), one ? 1 : q.shape(0), joints, temperature};
}

// Without the interpreter's lock: calls visit(i, reading) for every posture.
template <typename Visit>
void for_each(const Postures& postures, Visit&& visit) {
  const py::gil_scoped_release unlocked;
  std::vector<double> sines(2 * static_cast<std::size_t>(postures.joints));
  for (py::ssize_t i = 0; i < postures.count; ++i) {
    joint_sines(postures.q(i), sines);
    visit(i, JointReading(std::span<const double>(sines), postures.q(i), postures.temperature));
  }
}

py::array_t<double> tip(const PythonArm& self, const Array& q, const std::string& probe, double temperature) {
  const ForwardKinematics kinematics(self.arm, {}, probe_of(self.arm, probe));
  const Postures postures = postures_of(self.arm, q, temperature);
  py::array_t<double> tips({postures.count, py::ssize_t{3}});
  double* const out = tips.mutable_data();
  for_each(postures, [&](py::ssize_t i, const JointReading& reading) {
    Eigen::Map<Eigen::Vector3d>(out + 3 * i) = kinematics.tip_in_base(reading);
  });
  return tips;
}

// The kinematics write 3 × columns column by column: an array (postures, columns, 3), shown with its last axes
// exchanged.
template <typename Derivative>
py::array_t<double> derivatives(const Postures& postures, py::ssize_t columns, Derivative&& derivative) {
  py::array_t<double> blocks({postures.count, columns, py::ssize_t{3}});
  double* const out = blocks.mutable_data();
  for_each(postures, [&](py::ssize_t i, const JointReading& reading) { derivative(reading, out + 3 * columns * i); });
  const auto size = static_cast<py::ssize_t>(sizeof(double));
  return py::array_t<double>({postures.count, py::ssize_t{3}, columns}, {3 * columns * size, size, 3 * size}, out,
                             blocks);
}

std::vector<Parameter> chosen(const Arm& arm, const std::optional<std::vector<std::string>>& names) {
  if (!names) {
    return parameters_of(arm);
  }
  const auto all = all_parameters(arm);
  std::vector<Parameter> some;
  for (const std::string& name : *names) {
    const int at = find_parameter(all, name);
    if (at < 0) {
      raise(wrong_usage(fmt::format("the arm has no parameter {}", in_quotes(name))).value());
    }
    some.push_back(all[static_cast<std::size_t>(at)]);
  }
  return some;
}

py::array_t<double> jacobian(const PythonArm& self, const Array& q,
                             const std::optional<std::vector<std::string>>& parameters, const std::string& probe,
                             double temperature) {
  const ForwardKinematics kinematics(self.arm, chosen(self.arm, parameters), probe_of(self.arm, probe));
  return derivatives(postures_of(self.arm, q, temperature), kinematics.column_count(),
                     [&](const JointReading& reading, double* out) { kinematics.tip_in_base(reading, out); });
}

py::array_t<double> joint_jacobian(const PythonArm& self, const Array& q, const std::string& probe,
                                   double temperature) {
  const ForwardKinematics kinematics(self.arm, {}, probe_of(self.arm, probe));
  return derivatives(postures_of(self.arm, q, temperature), kinematics.joint_count(),
                     [&](const JointReading& reading, double* out) { kinematics.tip_by_joints(reading, out); });
}

template <typename Value>
auto of_parameters(const PythonArm& self, Value&& one) {
  std::vector<std::decay_t<decltype(one(self.arm, std::declval<const Parameter&>()))>> all;
  for (const Parameter& parameter : parameters_of(self.arm)) {
    all.push_back(one(self.arm, parameter));
  }
  return all;
}

py::array_t<double> parameter_values(const PythonArm& self) {
  const auto values = of_parameters(self, [](const Arm& arm, const Parameter& p) { return value(arm, p); });
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

PythonArm with_values(const PythonArm& self, const std::map<std::string, double>& values) {
  PythonArm changed{self.arm, std::nullopt};
  const auto all = all_parameters(self.arm);
  for (const auto& [name, number] : values) {
    const int at = find_parameter(all, name);
    if (at < 0) {
      raise(wrong_usage(fmt::format("the arm has no parameter {}", in_quotes(name))).value());
    }
    set_value(changed.arm, all[static_cast<std::size_t>(at)], number);
  }
  return changed;
}

std::vector<std::string> probe_names(const PythonArm& self) {
  std::vector<std::string> names;
  for (const Probe& probe : self.arm.probes) {
    names.push_back(probe.name);
  }
  return names;
}

}  // namespace

void add_arm(py::module_& module) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  using py::literals::operator""_a;
  py::class_<PythonArm>(module, "Arm",
                        "An arm of revolute joints with its probes. Lengths in mm, angles in rad. Immutable.")
      .def_static("from_file", &from_file, "path"_a,
                  "Reads arm.toml, nominal or as identify() writes it.\n\nRaises BadInputError.")
      .def_static("from_dh", &from_dh, "a"_a, "d"_a, "theta"_a, "alpha"_a, "tip"_a, "convention"_a = "standard",
                  "beta"_a = py::none(), "sign"_a = py::none(), "tip_radius"_a = 0.0, "name"_a = "arm",
                  "Makes an arm from Denavit-Hartenberg parameters: arrays of one number a joint.\n\n"
                  "a, d in mm; theta (zero offsets), alpha, beta (Hayati) in rad; sign +1 or -1; tip: x, y, z of the\n"
                  "probe's tip in the last joint's frame, mm. convention: 'standard' (Denavit and Hartenberg 1955) or\n"
                  "'modified' (Craig 1986, a and alpha of the link before).\n\nRaises UsageError.")
      .def_property_readonly("name", [](const PythonArm& self) { return self.arm.name; })
      .def_property_readonly(
          "convention",
          [](const PythonArm& self) { return self.arm.convention == Convention::Standard ? "standard" : "modified"; })
      .def_property_readonly("joint_count", [](const PythonArm& self) { return self.arm.joints.size(); })
      .def_property_readonly("probes", &probe_names, "Names of the probes.")
      .def_property_readonly(
          "reach", [](const PythonArm& self) { return reach(self.arm); }, "Length of the arm stretched out, mm.")
      .def_property_readonly(
          "parameters",
          [](const PythonArm& self) {
            return of_parameters(self, [](const Arm&, const Parameter& p) { return p.name; });
          },
          "Names of all structural parameters, in the order of values() and jacobian().")
      .def_property_readonly(
          "units",
          [](const PythonArm& self) {
            return of_parameters(self, [](const Arm&, const Parameter& p) { return std::string(p.unit()); });
          },
          "Unit of each parameter: mm or rad.")
      .def_property_readonly("values", &parameter_values, "Values of the parameters, shape (parameters,).")
      .def_property_readonly(
          "is_identified", [](const PythonArm& self) { return self.identification.has_value(); },
          "Whether the arm carries the covariance of an identification.")
      .def("with_values", &with_values, "values"_a, "A copy with parameters changed, by name; without a covariance.")
      .def("tip", &tip, "q"_a, "probe"_a = "", "temperature"_a = nan,
           "Forward kinematics: the tip's centre in the base frame.\n\n"
           "q: joint readings as the encoders give them, rad, shape (postures, joints) or (joints,).\n"
           "temperature: of the arm, degC; nan is the arm's reference.\n"
           "Returns shape (postures, 3), mm. A C-contiguous float64 array is read without a copy.")
      .def("jacobian", &jacobian, "q"_a, "parameters"_a = py::none(), "probe"_a = "", "temperature"_a = nan,
           "Derivative of the tip by the parameters named (default: all of .parameters), analytic.\n\n"
           "Returns shape (postures, 3, parameters), mm per unit of the parameter (Gao, Lu, Yang 2013, section 3).")
      .def("joint_jacobian", &joint_jacobian, "q"_a, "probe"_a = "", "temperature"_a = nan,
           "Derivative of the tip by the joint readings. Returns shape (postures, 3, joints), mm/rad.")
      .def(
          "to_toml", [](const PythonArm& self) { return arm_file_text(self.arm, self.identification); },
          "The text of an arm.toml with every digit: reading it back gives the same bits.")
      .def("__repr__", [](const PythonArm& self) {
        return fmt::format("<artcal.Arm {} with {} joints>", in_quotes(self.arm.name), self.arm.joints.size());
      });
}

}  // namespace artcal::python
