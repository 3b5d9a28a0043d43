#pragma once

#include <atomic>

namespace artcal {

/// While it lives, Ctrl-C and SIGTERM set `stop` the first time and end the program the second. Where a program calls a
/// command, that program's own handlers stay.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
  [[nodiscard]] const std::atomic<bool>& stop() const;

 private:
  bool is_handled_;
};

}  // namespace artcal
