#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

#include "app/output/capture.h"

namespace artcal {

/// A line on a terminal that says what a long identification is doing and for how long; nothing where the output is no
/// terminal. The line appears once the work has taken `patience` and is taken away at the end.
class IdentifyProgress {
 public:
  using Clock = std::chrono::steady_clock;
  IdentifyProgress(std::FILE* out, bool is_terminal, Clock::duration patience = std::chrono::seconds(2),
                   Clock::duration interval = std::chrono::milliseconds(500));
  ~IdentifyProgress();
  IdentifyProgress(const IdentifyProgress&) = delete;
  IdentifyProgress& operator=(const IdentifyProgress&) = delete;

  /// What is being done, and how much of it where that is known (`total` not 0). From any thread.
  void set(const std::string& what, std::size_t done, std::size_t total);

 private:
  void run(Clock::duration patience, Clock::duration interval);

  std::FILE* out_;
  Capture* caller_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool finished_ = false;
  bool shown_ = false;
  std::string what_ = "identification";
  std::size_t done_ = 0, total_ = 0;
  Clock::time_point start_ = Clock::now();
  std::thread ticker_;
};

/// "leave-one-placement-out cross-validation: 12 of 300, 4 s".
std::string identify_progress_text(const std::string& what, std::size_t done, std::size_t total, double seconds);

}  // namespace artcal
