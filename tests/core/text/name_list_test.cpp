#include "core/text/name_list.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::IsEmpty;

TEST(ListedNames, AreInQuotesAndOfManyTheFirstTwelve) {
  EXPECT_EQ(listed_names({}), "none");
  EXPECT_EQ(listed_names({"a", "b"}), "\"a\", \"b\"");
  const std::string many = listed_names(std::vector<std::string>(20, "x"));
  EXPECT_TRUE(many.ends_with("\"x\" and 8 more")) << many;
}

TEST(NearestName, IsThatOfAFewStrokes) {
  const std::vector<std::string> known{"placement", "probing", "noise", "seed", "a"};
  EXPECT_EQ(nearest_name("placements", known), "placement");
  EXPECT_EQ(nearest_name("plcement", known), "placement");
  EXPECT_EQ(nearest_name("nosie", known), "noise");
  EXPECT_THAT(nearest_name("b", known), IsEmpty()) << "one of one character is another name";
  EXPECT_THAT(nearest_name("readings", known), IsEmpty());
  EXPECT_THAT(nearest_name(std::string(100'000, 'k'), known), IsEmpty());
}

}  // namespace
}  // namespace artcal
