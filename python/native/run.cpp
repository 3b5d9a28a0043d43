// A command of the program, run in this process: the same requests, the same results.
#include "python/native/run.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <pybind11/stl.h>

#include "app/output/capture.h"
#include "app/shell/program.h"
#include "python/native/errors.h"

namespace artcal::python {
namespace {

namespace py = pybind11;
using namespace std::chrono_literals;

struct Stopped {};

/// What a command is doing, from its threads to the one that waits.
struct Stage {
  std::string what;
  std::size_t done = 0, total = 0;
};

/// A command at work on a thread of its own, so that this one can look after signals and progress.
class Work {
 public:
  explicit Work(std::vector<std::string> arguments) : arguments_(std::move(arguments)) {
    capture_.progress = [this](const std::string& what, std::size_t done, std::size_t total) {
      if (stop_) {
        throw Stopped{};
      }
      const std::lock_guard lock(mutex_);
      stage_ = Stage{what, done, total};
    };
    thread_ = std::jthread([this] { run(); });
  }

  /// Whether it has ended. Waits a little.
  bool ended() {
    std::unique_lock lock(mutex_);
    return wake_.wait_for(lock, 50ms, [this] { return ended_; });
  }
  void stop() { stop_ = true; }
  std::optional<Stage> news() {
    const std::lock_guard lock(mutex_);
    return std::exchange(stage_, std::nullopt);
  }
  /// REQUIRES: ended().
  const Capture& capture() const { return capture_; }
  int exit_code() const { return exit_code_; }
  std::exception_ptr thrown() const { return thrown_; }

 private:
  void run() {
    try {
      const CaptureScope scope(capture_);
      exit_code_ = run_program(arguments_);
    } catch (...) {
      thrown_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    wake_.notify_all();
  }

  std::vector<std::string> arguments_;
  Capture capture_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ended_ = false;
  std::optional<Stage> stage_;
  int exit_code_ = 0;
  std::exception_ptr thrown_;
  std::jthread thread_;  // the last: it uses all of the above
};

bool wait_a_little(Work& work) {
  const py::gil_scoped_release unlocked;
  return work.ended();
}

void tell(Work& work, const std::optional<py::function>& progress) {
  if (const auto stage = work.news(); stage && progress) {
    (*progress)(stage->what, stage->done, stage->total);
  }
}

py::tuple run(std::vector<std::string> arguments, const std::optional<py::function>& progress) {
  Work work(std::move(arguments));
  std::exception_ptr interrupted;
  while (!wait_a_little(work)) {
    try {
      if (!interrupted) {
        if (PyErr_CheckSignals() != 0) {  // Ctrl-C
          throw py::error_already_set();
        }
        tell(work, progress);
      }
    } catch (const py::error_already_set&) {
      interrupted = std::current_exception();
      work.stop();
    }
  }
  if (interrupted) {
    std::rethrow_exception(interrupted);
  }
  if (work.thrown()) {
    std::rethrow_exception(work.thrown());
  }
  tell(work, progress);
  if (work.capture().error) {
    raise(*work.capture().error);
  }
  return py::make_tuple(work.exit_code(), work.capture().json, work.capture().text);
}

}  // namespace

void add_run(py::module_& module) {
  using py::literals::operator""_a;
  module.def("run", &run, "arguments"_a, "progress"_a = py::none(),
             "Runs a command of the program in this process. Returns its exit code, JSON and text.");
}

}  // namespace artcal::python
