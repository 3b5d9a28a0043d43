#include "core/toml/toml_keys.h"

#include <string>

#include <gtest/gtest.h>

namespace artcal {
namespace {

std::string key(int parts) {
  std::string text = "a";
  for (int i = 1; i < parts; ++i) {
    text += ".a";
  }
  return text;
}

TEST(TomlKeys, ThirtyTwoPartsAreTheMost) {
  EXPECT_EQ(line_of_endless_key(key(32) + " = 1"), 0);
  EXPECT_EQ(line_of_endless_key(key(33) + " = 1"), 1);
  EXPECT_EQ(line_of_endless_key("x = 1\n\n[" + key(33) + "]\n"), 3);
}

TEST(TomlKeys, EveryKeyIsCountedForItself) {
  EXPECT_EQ(line_of_endless_key(key(20) + " = 1.5\n" + key(20) + " = 2.5\n"), 0);
  EXPECT_EQ(line_of_endless_key("t = { " + key(20) + " = 1.5, " + key(20) + " = [1.5, 2.5] }"), 0);
  EXPECT_EQ(line_of_endless_key("t = { " + key(20) + " = 1.5, " + key(33) + " = 1 }"), 1);
}

TEST(TomlKeys, QuotedPartsCountOnceWhateverTheyHold) {
  EXPECT_EQ(line_of_endless_key("\"" + key(40) + "\".'" + key(40) + "' = 1"), 0);
  std::string quoted = "\"=\"";
  for (int i = 1; i < 33; ++i) {
    quoted += i % 2 == 0 ? ".\"=\"" : ".'#'";
  }
  EXPECT_EQ(line_of_endless_key(quoted + " = 1"), 1);
}

TEST(TomlKeys, RunsOfQuotesAreStringsOneAfterTheOther) {
  // Three quotes open, three close, and two more may belong to the string (TOML 1.0, "String").
  for (const char* string : {"\"\"\"a\"\"\"", "\"\"\"a\"\"\"\"", "\"\"\"a\"\"\"\"\"", "'''a'''", "'''a'''''"}) {
    EXPECT_EQ(line_of_endless_key(std::string("x = ") + string + "\n" + key(33) + " = 1"), 2) << string;
  }
}

TEST(TomlKeys, OpenStringsEndTheText) {
  for (const char* open : {"\"", "'", "\"\"\"", "'''", "\"\\", "\"\"\"x\"\""}) {
    EXPECT_EQ(line_of_endless_key(open), 0);
  }
}

}  // namespace
}  // namespace artcal
