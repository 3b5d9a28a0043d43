#pragma once

#include <cstddef>
#include <functional>

namespace artcal {

/// While one lives, `threads` ≤ 0 means one on the thread that made it: for work that is itself done side by side, such
/// as each recording of a batch.
class OneThreadOnly {
 public:
  OneThreadOnly();
  ~OneThreadOnly();
  OneThreadOnly(const OneThreadOnly&) = delete;
  OneThreadOnly& operator=(const OneThreadOnly&) = delete;

 private:
  bool before_;
};

/// Threads for `items` pieces of work: `asked`, or where that is 0 or less as many as the machine has, but one inside
/// of such work; never more than there are items, nor more than 256, and at least one.
int thread_count(int asked, std::size_t items);

/// Calls work() once on each of `threads` threads, the caller's among them, and returns when all have returned. Where
/// the system gives fewer threads, so many do it: work() shares its items out by itself. An exception of one call is
/// thrown again here when the others have returned. REQUIRES: threads ≥ 1.
void on_threads(int threads, const std::function<void()>& work);

/// Calls item(i) for every i in [0, count), in any order and side by side. The result does not depend on the number of
/// threads where each item writes to a place of its own.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& item);

/// Calls `aside` on a thread of its own, where there may be one, while `work` on the caller's shares itself out on
/// threads as it likes; returns when both have. An exception of either is thrown again here.
void side_by_side(const std::function<void()>& aside, const std::function<void()>& work);

/// Calls block(begin, end) for [0, count) cut into blocks of `size`, side by side on as many threads as the machine
/// has; one block alone at once, without any of that. The blocks do not depend on the number of threads: sums of each,
/// added in the order of the blocks, have the same digits on one thread and on many.
template <typename Block>
void parallel_blocks(std::size_t count, std::size_t size, const Block& block) {
  if (count <= size) {
    if (count > 0) {
      block(std::size_t{0}, count);
    }
    return;
  }
  parallel_for((count + size - 1) / size, 0,
               [&](std::size_t i) { block(i * size, count - i * size < size ? count : (i + 1) * size); });
}

}  // namespace artcal
