#include "core/parallel.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace artcal {
namespace {

using ::testing::Each;

TEST(Parallel, EveryItemIsDoneOnce) {
  for (const int threads : {0, 1, 2, 7, 300}) {
    std::vector<int> calls(1000, 0);
    parallel_for(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    EXPECT_THAT(calls, Each(1)) << threads;
  }
  parallel_for(0, 4, [](std::size_t) { FAIL(); });
}

TEST(Parallel, ThreadsAreNeverMoreThanItems) {
  EXPECT_EQ(thread_count(8, 3), 3);
  EXPECT_EQ(thread_count(2, 3), 2);
  EXPECT_EQ(thread_count(5, 0), 1);
  EXPECT_EQ(thread_count(100000, 100000), 256);
  EXPECT_GE(thread_count(0, 1000), 1);
}

TEST(Parallel, AnExceptionReachesTheCallerWhenAllHaveReturned) {
  std::atomic<int> returned{0};
  const auto work = [&] {
    if (returned++ == 0) {
      throw std::runtime_error("of one thread");
    }
  };
  EXPECT_THROW(on_threads(4, work), std::runtime_error);
  EXPECT_EQ(returned, 4);
}

}  // namespace
}  // namespace artcal
