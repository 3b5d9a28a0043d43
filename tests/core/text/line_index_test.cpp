#include "core/text/line_index.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(LineIndex, GivesTheLineOfEveryByte) {
  const LineIndex lines("a\n\nbc\nd");
  const int expected[] = {1, 1, 2, 3, 3, 3, 4, 4};
  for (std::size_t offset = 0; offset < 8; ++offset) {
    EXPECT_EQ(lines.line_at(offset), expected[offset]) << offset;
  }
  EXPECT_EQ(lines.line_at(1000), 4) << "beyond the end";
  EXPECT_EQ(LineIndex("").line_at(0), 1);
}

}  // namespace
}  // namespace artcal
