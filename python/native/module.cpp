#include <glog/logging.h>
#include <pybind11/pybind11.h>

#include "app/version.h"
#include "python/native/arm.h"
#include "python/native/errors.h"
#include "python/native/run.h"

PYBIND11_MODULE(_native, module) {
  FLAGS_minloglevel = google::GLOG_FATAL;  // as in app/main.cpp
  module.doc() = "The compiled part of artcal.";
  module.attr("__version__") = artcal::program_version;
  artcal::python::add_errors(module);
  artcal::python::add_arm(module);
  artcal::python::add_run(module);
}
