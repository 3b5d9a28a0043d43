#include "core/error.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(Error, TextHasThePlaceFirst) {
  EXPECT_EQ((Error{ErrorCode::BadInput, "found x", "a.csv:3:1"}.text()), "a.csv:3:1: found x");
  EXPECT_EQ((Error{ErrorCode::Usage, "no such option", ""}.text()), "no such option");
}

TEST(Error, TextIsOneHarmlessLine) {
  EXPECT_EQ((Error{ErrorCode::BadInput, "a\x1b[2Jb", "new\nline.csv"}.text()), "new?line.csv: a?[2Jb");
}

// The program's exit codes; scripts rely on them.
TEST(Error, CodesAreTheExitCodes) {
  EXPECT_EQ(static_cast<int>(wrong_usage("").value().code), 2);
  EXPECT_EQ(static_cast<int>(bad_input("").value().code), 3);
  EXPECT_EQ(static_cast<int>(no_solution("").value().code), 4);
}

}  // namespace
}  // namespace artcal
