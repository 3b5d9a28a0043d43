#include "core/text/decimal_comma.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(DecimalComma, IsAskedAboutWithTheNumberAsItShouldBe) {
  EXPECT_THAT(decimal_comma_question("3,5 um"), HasSubstr("decimal comma? Write \"3,5 um\" with a point: 3.5 um"));
  EXPECT_THAT(decimal_comma_question(" -0,25"), HasSubstr(": -0.25"));
  EXPECT_THAT(decimal_comma_question("1,5e-3"), HasSubstr(": 1.5e-3"));
  EXPECT_THAT(decimal_comma_question_of_line("d = 3,5  # mm"), HasSubstr(": 3.5"));
}

TEST(DecimalComma, OfNothingElse) {
  for (const char* text : {"", "3.5", "600,0,450", "1,234.5", "a,5", ",5", "5,", "x", "-", "1,x"}) {
    EXPECT_THAT(decimal_comma_question(text), IsEmpty()) << text;
  }
  EXPECT_THAT(decimal_comma_question_of_line("d = [3,5]"), IsEmpty());
  EXPECT_THAT(decimal_comma_question_of_line("3,5"), IsEmpty());
}

}  // namespace
}  // namespace artcal
