#include "core/parallel.h"

#include <algorithm>
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

// Each recording of a batch is one of several pieces of work: what it does by itself shares no more threads out.
TEST(Parallel, WorkInsideOfWorkHasOneThread) {
  const int of_machine = thread_count(0, 1000);
  {
    const OneThreadOnly outer;
    EXPECT_EQ(thread_count(0, 1000), 1);
    { const OneThreadOnly inner; }
    EXPECT_EQ(thread_count(0, 1000), 1);
    EXPECT_EQ(thread_count(3, 1000), 3);
  }
  std::atomic<int> most{0};
  on_threads(2, [&] { most = std::max(most.load(), thread_count(0, 1000)); });
  EXPECT_EQ(most, 1);
  on_threads(1, [&] { EXPECT_EQ(thread_count(0, 1000), of_machine); });
  EXPECT_EQ(thread_count(0, 1000), of_machine);
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

TEST(Parallel, WhatIsDoneAsideTakesNoThreadsFromTheWork) {
  bool done_aside = false;
  int of_work = 0;
  side_by_side([&] { done_aside = true; }, [&] { of_work = thread_count(0, 1000); });
  EXPECT_TRUE(done_aside);
  EXPECT_EQ(of_work, thread_count(0, 1000));
  const OneThreadOnly inside;
  std::string order;
  side_by_side([&] { order += "aside"; }, [&] { order += "work, "; });
  EXPECT_EQ(order, "work, aside");
}

TEST(Parallel, AnExceptionOfEitherSideReachesTheCaller) {
  const auto nothing = [] {};
  const auto fails = [] { throw std::runtime_error("of one side"); };
  EXPECT_THROW(side_by_side(fails, nothing), std::runtime_error);
  EXPECT_THROW(side_by_side(nothing, fails), std::runtime_error);
}

}  // namespace
}  // namespace artcal
