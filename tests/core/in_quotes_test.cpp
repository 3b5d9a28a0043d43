#include "core/in_quotes.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(InQuotes, ShowsShortTextAsItIs) {
  EXPECT_EQ(in_quotes("q1"), "\"q1\"");
  EXPECT_EQ(in_quotes(""), "\"\"");
}

TEST(InQuotes, CutsAfterFortyCharactersNotBytes) {
  const std::string forty(40, 'x');
  EXPECT_EQ(in_quotes(forty), "\"" + forty + "\"");
  EXPECT_EQ(in_quotes(forty + "y"), "\"" + forty + "…\"");
  std::string micro;
  for (int i = 0; i < 41; ++i) {
    micro += "µ";
  }
  EXPECT_EQ(in_quotes(micro), "\"" + micro.substr(0, 80) + "…\"");
}

TEST(InQuotes, DisarmsControlCharacters) { EXPECT_EQ(in_quotes("\x1b[2J\n\x7f"), "\"?[2J??\""); }

TEST(InQuotes, CountsCharacters) {
  EXPECT_EQ(character_count("µm €"), 4u);
  EXPECT_EQ(character_count(""), 0u);
}

}  // namespace
}  // namespace artcal
