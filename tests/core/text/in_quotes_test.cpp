#include "core/text/in_quotes.h"

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

TEST(InQuotes, CountsEveryByteThatIsNoPartOfUtf8) {
  EXPECT_EQ(in_quotes(std::string(3000, '\xbd')), "\"" + std::string(40, '?') + "…\"");
  EXPECT_EQ(in_quotes("a\xbd"
                      "b\xc3"),
            "\"a?b?\"")
      << "a stray byte, and a character that is cut off";
  EXPECT_EQ(in_quotes("Gr\xf6\xdf"
                      "e é"),
            "\"Gr??e é\"")
      << "Latin-1";
}

TEST(InQuotes, DisarmsControlCharacters) { EXPECT_EQ(in_quotes("\x1b[2J\n\x7f"), "\"?[2J??\""); }

TEST(InQuotes, DisarmsWhatIsLongerThanAByte) {
  EXPECT_EQ(in_quotes("a\u009b2Jb"), "\"a?2Jb\"") << "CSI as one character";
  EXPECT_EQ(in_quotes("a\u202eb\u2066c\u2028d"), "\"a?b?c?d\"") << "reading turned round";
  EXPECT_EQ(in_quotes("é\u00a0–“x”€"), "\"é\u00a0–“x”€\"") << "neighbours of these are text";
}

TEST(FindControl, FindsTheFirst) {
  EXPECT_FALSE(find_control("é\u00a0– \t“x”€"));
  const auto found = find_control("µ\u009b\x1b");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->offset, 2u);
  EXPECT_EQ(found->length, 2u);
  EXPECT_EQ(found->code, 0x9b);
  EXPECT_EQ(find_control("a\u202e")->code, 0x202e);
  EXPECT_EQ(find_control("\x7f")->code, 0x7f);
  EXPECT_FALSE(find_control("\xe2")) << "cut off";
}

TEST(InQuotes, CountsCharacters) {
  EXPECT_EQ(character_count("µm €"), 4u);
  EXPECT_EQ(character_count(""), 0u);
}

}  // namespace
}  // namespace artcal
