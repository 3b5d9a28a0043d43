#pragma once

#include <pybind11/pybind11.h>

namespace artcal::python {

/// Adds the class Arm to the module.
void add_arm(pybind11::module_& module);

}  // namespace artcal::python
