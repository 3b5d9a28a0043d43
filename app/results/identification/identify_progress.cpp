#include "app/results/identification/identify_progress.h"

#include <fmt/format.h>

namespace artcal {

std::string identify_progress_text(const std::string& what, std::size_t done, std::size_t total, double seconds) {
  return total > 0 ? fmt::format("{}: {} of {}, {:.0f} s", what, done, total, seconds)
                   : fmt::format("{}, {:.0f} s", what, seconds);
}

IdentifyProgress::IdentifyProgress(std::FILE* out, bool is_terminal, Clock::duration patience, Clock::duration interval)
    : out_(out), caller_(current_capture()) {
  if (is_terminal && caller_ == nullptr) {
    ticker_ = std::thread([this, patience, interval] { run(patience, interval); });
  }
}

IdentifyProgress::~IdentifyProgress() {
  if (!ticker_.joinable()) {
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  wake_.notify_one();
  ticker_.join();
  if (shown_) {
    fmt::print(out_, "\r\033[K");
    std::fflush(out_);
  }
}

void IdentifyProgress::set(const std::string& what, std::size_t done, std::size_t total) {
  if (caller_ != nullptr && caller_->progress) {
    caller_->progress(what, done, total);
  }
  const std::lock_guard lock(mutex_);
  what_ = what;
  done_ = done;
  total_ = total;
}

void IdentifyProgress::run(Clock::duration patience, Clock::duration interval) {
  std::unique_lock lock(mutex_);
  auto next = start_ + patience;
  while (!wake_.wait_until(lock, next, [this] { return finished_; })) {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    fmt::print(out_, "\r{}\033[K", identify_progress_text(what_, done_, total_, seconds));
    std::fflush(out_);
    shown_ = true;
    next += interval;
  }
}

}  // namespace artcal
