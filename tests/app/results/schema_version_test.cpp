#include "app/results/schema_version.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/report/report.h"
#include "app/report/result_file.h"
#include "core/files/text_file.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

std::string old_result(const std::string& name) {
  return std::string(ARTCAL_SOURCE_DIR) + "/tests/reference/results-schema-1/" + name;
}

Json read(const std::string& path) { return Json::parse(read_text_file(path, 1 << 24)->text); }

TEST(SchemaVersion, RenamesWhatTheFirstSchemaNamedDifferently) {
  Json result = read(old_result("identification.json"));
  const Json before = result;
  ASSERT_EQ(before["schema_version"], 1);
  ASSERT_TRUE(bring_up_to_date(result));
  EXPECT_EQ(result["schema_version"], 2);
  EXPECT_EQ(result["noise"]["scale_factor"], before["noise"]["enlargement"]);
  ASSERT_EQ(result["coupling"]["unidentifiable"].size(), before["coupling"]["lost"].size());
  ASSERT_GT(result["coupling"]["unidentifiable"].size(), 0u);
  EXPECT_EQ(result["coupling"]["unidentifiable"][0]["fixed"], before["coupling"]["lost"][0]["held"]);
  EXPECT_EQ(result["coupling"]["unidentifiable"][0]["motion"], before["coupling"]["lost"][0]["unseen_motion"]);
  int unidentifiable = 0;
  for (std::size_t i = 0; i < before["parameters"].size(); ++i) {
    const Json& was = before["parameters"][i]["state"];
    const Json& is = result["parameters"][i]["state"];
    unidentifiable += was == "lost" && is == "unidentifiable" ? 1 : 0;
    EXPECT_TRUE(is != "held" && is != "lost");
  }
  EXPECT_GT(unidentifiable, 0);
  EXPECT_EQ(result.size(), before.size());
  auto key = before.begin();
  for (auto& [name, value] : result.items()) {
    EXPECT_EQ(name, (key++).key());
  }
}

TEST(SchemaVersion, AHeldParameterIsFixed) {
  Json result = {{"schema_version", 1}, {"parameters", {{{"name", "a6"}, {"state", "held"}}}}};
  ASSERT_TRUE(bring_up_to_date(result));
  EXPECT_EQ(result["parameters"][0]["state"], "fixed");
}

TEST(SchemaVersion, RefusesOthers) {
  Json later = {{"schema_version", 3}};
  EXPECT_FALSE(bring_up_to_date(later));
  Json none = Json::object();
  EXPECT_FALSE(bring_up_to_date(none));
  Json list = Json::array({1});
  EXPECT_FALSE(bring_up_to_date(list));
}

TEST(SchemaVersion, FieldsOfAnotherTypeStayAsTheyAre) {
  Json odd = {{"schema_version", 1}, {"coupling", 7}, {"parameters", "lost"}, {"noise", Json::array({1})}};
  Json expected = odd;
  expected["schema_version"] = 2;
  ASSERT_TRUE(bring_up_to_date(odd));
  EXPECT_EQ(odd, expected);
}

TEST(SchemaVersion, AReportOfOldResultsIsMade) {
  for (const char* name : {"identification.json", "monte-carlo.json"}) {
    std::vector<InputFile> inputs;
    const auto result = read_result(old_result(name), inputs);
    ASSERT_TRUE(result) << result.error().text();
    const auto page = report_html({*result}, Scripts::SharedPlots);
    ASSERT_TRUE(page) << page.error().text();
    if (std::string(name) == "identification.json") {
      EXPECT_THAT(*page, HasSubstr("not identifiable"));
    }
  }
}

}  // namespace
}  // namespace artcal
