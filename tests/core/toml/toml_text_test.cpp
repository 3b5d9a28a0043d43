#include "core/toml/toml_text.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(TomlText, QuotesWhatTomlWouldMisread) {
  EXPECT_EQ(toml_text("ball bar"), "\"ball bar\"");
  EXPECT_EQ(toml_text("a\"b\\c"), "\"a\\\"b\\\\c\"");
  EXPECT_EQ(toml_text("line\nend\x7f"), "\"line\\u000Aend\\u007F\"");
  EXPECT_EQ(toml_text("größe"), "\"größe\"");
}

TEST(TomlText, NumbersAreFloatsWithEveryDigit) {
  EXPECT_EQ(toml_number(1.0), "1.0");
  EXPECT_EQ(toml_number(0.1), "0.1");
  EXPECT_EQ(toml_number(1e-20), "1e-20");
  EXPECT_EQ(toml_number(-183.5), "-183.5");
}

}  // namespace
}  // namespace artcal
