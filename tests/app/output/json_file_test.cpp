// JSON that anybody may have written.
#include "app/output/json_file.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::string& text) {
  const auto json = parse_json(text, "result of artcal", "r.json");
  return json ? "accepted" : json.error().text();
}

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(JsonFile, ReadsWhatTheLibraryReads) {
  const std::string text =
      R"({"b":[1,-2,3.5,1e300,true,false,null,"é\n"],"a":{"z":{},"y":[]},"big":18446744073709551615})";
  const auto json = parse_json(text, "result", "r.json");
  ASSERT_TRUE(json) << json.error().text();
  EXPECT_EQ(*json, nlohmann::ordered_json::parse(text));
  EXPECT_EQ(json->dump(), nlohmann::ordered_json::parse(text).dump()) << "in the same order";
}

TEST(JsonFile, RefusesWhatIsNoJson) {
  for (const char* text : {"", "{", "[1,2", "{\"a\":1,}", "nul", "[1e999]", "{\"a\" 1}", "\"\\ud800\"", "[1]x"}) {
    EXPECT_THAT(refusal(text), HasSubstr("r.json: this is no result of artcal: it is not valid JSON")) << text;
  }
}

TEST(JsonFile, RefusesDeepNestingWhereItIsRead) {
  EXPECT_EQ(refusal(nested(max_json_depth)), "accepted");
  EXPECT_THAT(refusal(nested(max_json_depth + 1)), HasSubstr("nested more than 64 deep"));
  EXPECT_THAT(refusal(std::string(5'000'000, '[')), HasSubstr("nested more than 64 deep"));
  std::string objects;
  for (int i = 0; i < 1'000'000; ++i) {
    objects += "{\"a\":";
  }
  EXPECT_THAT(refusal(objects), HasSubstr("nested more than 64 deep"));
}

TEST(JsonFile, RefusesAKeyThatIsThereTwice) {
  EXPECT_THAT(refusal(R"([{"a":1,"b":2,"a":3}])"), HasSubstr("the key \"a\" is there twice in one object"));
}

}  // namespace
}  // namespace artcal
