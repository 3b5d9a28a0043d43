#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace artcal {

/// Tells how far long work is: on a terminal one line that changes, in a log a plain line now and then.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;
  Progress(std::FILE* out, std::size_t total, bool is_terminal);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more is done, and whether it failed.
  void step(bool failed) { step(failed, Clock::now()); }
  void step(bool failed, Clock::time_point now);

 private:
  void say(Clock::time_point now);

  std::FILE* out_;
  std::size_t total_, done_ = 0, failed_ = 0;
  bool is_terminal_;
  Clock::time_point start_ = Clock::now(), said_ = start_;
};

/// "120 of 1000 recordings, 3 failed, 152/s, 6 s left".
std::string progress_text(std::size_t done, std::size_t total, std::size_t failed, double seconds);

}  // namespace artcal
