#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace artcal {
namespace {

constexpr int max_threads = 256;

}  // namespace

int thread_count(int asked, std::size_t items) {
  const int wanted = asked > 0 ? asked : static_cast<int>(std::thread::hardware_concurrency());
  const auto useful = static_cast<int>(std::min(items, static_cast<std::size_t>(max_threads)));
  return std::clamp(wanted, 1, std::max(1, useful));
}

void on_threads(int threads, const std::function<void()>& work) {
  std::mutex guard;
  std::exception_ptr first;
  const auto guarded = [&] {
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

}  // namespace artcal
