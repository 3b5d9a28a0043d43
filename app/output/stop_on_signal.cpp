#include "app/output/stop_on_signal.h"

#include <csignal>

#include "app/output/capture.h"

namespace artcal {
namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void ask_to_stop(int signal) {
  stop_asked.store(true);
  std::signal(signal, SIG_DFL);
}

}  // namespace

StopOnSignal::StopOnSignal() : is_handled_(current_capture() == nullptr) {
  stop_asked.store(false);
  if (is_handled_) {
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
  }
}

StopOnSignal::~StopOnSignal() {
  if (is_handled_) {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }
}

const std::atomic<bool>& StopOnSignal::stop() const { return stop_asked; }

}  // namespace artcal
