#include "python/native/errors.h"

namespace artcal::python {

namespace py = pybind11;

void raise(const Error& error) { throw Raised{error}; }

void add_errors(py::module_& /*module*/) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const Raised& raised) {
      const py::object make = py::module_::import("artcal.errors").attr("error_of");
      const py::object error = make(static_cast<int>(raised.error.code), raised.error.message, raised.error.where);
      PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
    }
  });
}

}  // namespace artcal::python
