#include "app/batch/progress.h"

#include <fmt/format.h>

namespace artcal {
namespace {

using namespace std::chrono_literals;

std::string duration_text(double seconds) {
  return seconds < 90.0     ? fmt::format("{:.0f} s", seconds)
         : seconds < 5400.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                            : fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

std::string progress_text(std::size_t done, std::size_t total, std::size_t failed, double seconds) {
  std::string text = fmt::format("{} of {} recordings", done, total);
  if (failed > 0) {
    text += fmt::format(", {} failed", failed);
  }
  if (done > 0 && seconds > 0.0) {
    const double rate = static_cast<double>(done) / seconds;
    text += fmt::format(", {:.{}f}/s, {} left", rate, rate < 10.0 ? 1 : 0,
                        duration_text(static_cast<double>(total - done) / rate));
  }
  return text;
}

Progress::Progress(std::FILE* out, std::size_t total, bool is_terminal)
    : out_(out), total_(total), is_terminal_(is_terminal) {}

Progress::~Progress() {
  if (is_terminal_ && done_ > 0) {
    fmt::print(out_, "\r\033[K");
    std::fflush(out_);
  }
}

void Progress::step(bool failed, Clock::time_point now) {
  ++done_;
  failed_ += failed;
  if (now - said_ >= (is_terminal_ ? 200ms : 10000ms)) {
    said_ = now;
    say(now);
  }
}

void Progress::say(Clock::time_point now) {
  const std::string text = progress_text(done_, total_, failed_, std::chrono::duration<double>(now - start_).count());
  if (is_terminal_) {
    fmt::print(out_, "\r{}\033[K", text);
  } else {
    fmt::print(out_, "artcal: {}\n", text);
  }
  std::fflush(out_);
}

}  // namespace artcal
