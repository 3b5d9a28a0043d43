#include "app/batch/progress.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(Progress, SaysRateAndTimeLeft) {
  EXPECT_EQ(progress_text(0, 1000, 0, 0.0), "0 of 1000 recordings");
  EXPECT_EQ(progress_text(200, 1000, 3, 2.0), "200 of 1000 recordings, 3 failed, 100/s, 8 s left");
  EXPECT_EQ(progress_text(10, 1000, 0, 10.0), "10 of 1000 recordings, 1.0/s, 16 min left");
  EXPECT_EQ(progress_text(10, 100000, 0, 10.0), "10 of 100000 recordings, 1.0/s, 27.8 h left");
}

// What it writes when each of ten steps takes so long.
std::string written(bool is_terminal, std::chrono::milliseconds step) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* file = ::open_memstream(&text, &size);
  {
    Progress progress(file, 10, is_terminal);
    auto now = Progress::Clock::now();
    for (int i = 0; i < 10; ++i) {
      progress.step(false, now += step);
    }
  }
  std::fclose(file);
  std::string all(text, size);
  std::free(text);
  return all;
}

TEST(Progress, IsALineThatChangesOnATerminalAndPlainLinesInALog) {
  using namespace std::chrono_literals;
  EXPECT_EQ(written(false, 1ms), "");
  EXPECT_EQ(written(false, 4s).find('\r'), std::string::npos);
  const std::string log = written(false, 4s);
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 3) << log;
  const std::string terminal = written(true, 1s);
  EXPECT_EQ(terminal.find('\n'), std::string::npos);
  EXPECT_TRUE(terminal.ends_with("\r\033[K")) << "nothing is left of it";
}

}  // namespace
}  // namespace artcal
