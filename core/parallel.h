#pragma once

#include <cstddef>
#include <functional>

namespace artcal {

/// Threads for `items` pieces of work: `asked`, or where that is 0 or less as many as the machine has; never more than
/// there are items, nor more than 256, and at least one.
int thread_count(int asked, std::size_t items);

/// Calls work() once on each of `threads` threads, the caller's among them, and returns when all have returned. Where
/// the system gives fewer threads, so many do it: work() shares its items out by itself. An exception of one call is
/// thrown again here when the others have returned. REQUIRES: threads ≥ 1.
void on_threads(int threads, const std::function<void()>& work);

/// Calls item(i) for every i in [0, count), in any order and side by side. The result does not depend on the number of
/// threads where each item writes to a place of its own.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& item);

}  // namespace artcal
