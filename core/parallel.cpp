#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace artcal {
namespace {

constexpr int max_threads = 256;

thread_local bool one_thread_only = false;

int threads_of_machine() { return one_thread_only ? 1 : static_cast<int>(std::thread::hardware_concurrency()); }

}  // namespace

OneThreadOnly::OneThreadOnly() : before_(std::exchange(one_thread_only, true)) {}

OneThreadOnly::~OneThreadOnly() { one_thread_only = before_; }

int thread_count(int asked, std::size_t items) {
  if (items <= 1) {
    return 1;  // without asking the system
  }
  const int wanted = asked > 0 ? asked : threads_of_machine();
  const auto useful = static_cast<int>(std::min(items, static_cast<std::size_t>(max_threads)));
  return std::clamp(wanted, 1, std::max(1, useful));
}

void on_threads(int threads, const std::function<void()>& work) {
  std::mutex guard;
  std::exception_ptr first;
  const auto guarded = [&] {
    std::optional<OneThreadOnly> inside;
    if (threads > 1) {
      inside.emplace();
    }
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(guard);
      if (!first) {
        first = std::current_exception();
      }
    }
  };
  // Plain threads rather than a pool: the thread sanitizer sees all of them, as it does not with Debian's libtbb.
  std::vector<std::jthread> others;
  others.reserve(static_cast<std::size_t>(threads));
  try {
    while (static_cast<int>(others.size()) + 1 < threads) {
      others.emplace_back(guarded);
    }
  } catch (const std::system_error&) {
    // No more threads: those that there are do the work.
  }
  guarded();
  others.clear();
  if (first) {
    std::rethrow_exception(first);
  }
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& item) {
  std::atomic<std::size_t> next{0};
  on_threads(thread_count(threads, count), [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      item(i);
    }
  });
}

void side_by_side(const std::function<void()>& aside, const std::function<void()>& work) {
  std::future<void> done;
  if (thread_count(0, 2) > 1) {
    try {
      done = std::async(std::launch::async, aside);
    } catch (const std::system_error&) {
      // No thread: one after the other.
    }
  }
  work();
  done.valid() ? done.get() : aside();
}

}  // namespace artcal
