#pragma once

#include <utility>

#include <pybind11/pybind11.h>

#include "core/error.h"

namespace artcal::python {

/// An Error on its way to Python, where it becomes artcal.Error's subclass of its code.
struct Raised {
  Error error;
};

[[noreturn]] void raise(const Error& error);

template <typename Value>
Value value_or_raise(Expected<Value> expected) {
  if (!expected) {
    raise(expected.error());
  }
  return std::move(*expected);
}

/// Lets Raised become an exception of artcal.errors.
void add_errors(pybind11::module_& module);

}  // namespace artcal::python
