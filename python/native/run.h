#pragma once

#include <pybind11/pybind11.h>

namespace artcal::python {

/// Adds run(arguments, progress): a command of the program, in this process.
void add_run(pybind11::module_& module);

}  // namespace artcal::python
