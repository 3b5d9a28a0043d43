#include "app/results/identification/identify_progress.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

using namespace std::chrono_literals;

std::string written_by(bool is_terminal, IdentifyProgress::Clock::duration patience) {
  std::FILE* file = std::tmpfile();
  {
    IdentifyProgress progress(file, is_terminal, patience, 5ms);
    progress.set("leave-one-placement-out cross-validation", 12, 300);
    std::this_thread::sleep_for(200ms);
  }
  std::rewind(file);
  std::string text(10000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  return text;
}

TEST(IdentifyProgress, TellsOnATerminalWhatTakesLong) {
  const std::string text = written_by(true, 10ms);
  EXPECT_NE(text.find("\rleave-one-placement-out cross-validation: 12 of 300, 0 s"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\r\033[K")) << "the line is taken away at the end";
}

TEST(IdentifyProgress, IsSilentWhereWorkIsShortOrNobodyWatches) {
  EXPECT_EQ(written_by(true, 1h), "");
  EXPECT_EQ(written_by(false, 10ms), "");
}

}  // namespace
}  // namespace artcal
