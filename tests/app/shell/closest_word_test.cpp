#include "app/shell/closest_word.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::Eq;
using ::testing::Optional;

const std::vector<std::string> words{"identify", "points", "plan", "simulate", "--report", "--report-pages"};

TEST(ClosestWord, IsAFewChangesAway) {
  EXPECT_THAT(closest_word("identfy", words), Optional(Eq("identify")));    // a letter missing
  EXPECT_THAT(closest_word("identiffy", words), Optional(Eq("identify")));  // one too many
  EXPECT_THAT(closest_word("plna", words), Optional(Eq("plan")));           // two exchanged
  EXPECT_THAT(closest_word("pints", words), Optional(Eq("points")));
  EXPECT_THAT(closest_word("--reprt", words), Optional(Eq("--report")));
}

TEST(ClosestWord, OrOneThatBeginsSo) {
  EXPECT_THAT(closest_word("sim", words), Optional(Eq("simulate")));
  EXPECT_EQ(closest_word("p", {"points", "plan"}), std::nullopt);  // two do
}

TEST(ClosestWord, IsNoneWhereNothingIsNear) {
  EXPECT_EQ(closest_word("calibrate", words), std::nullopt);
  EXPECT_EQ(closest_word("", words), std::nullopt);
  EXPECT_EQ(closest_word(std::string(100'000, 'x'), words), std::nullopt);
  EXPECT_EQ(did_you_mean("calibrate", words), "");
  EXPECT_EQ(did_you_mean("plann", words), "; did you mean plan?");
}

}  // namespace
}  // namespace artcal
