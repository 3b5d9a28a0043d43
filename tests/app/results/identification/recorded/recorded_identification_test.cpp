// The identification that an earlier version wrote (tests/reference/results-schema-1): its parts by hand from the JSON.
#include "app/results/identification/recorded/recorded_identification.h"

#include <gtest/gtest.h>

#include "app/results/schema_version.h"
#include "core/files/text_file.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

class RecordedIdentificationTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    whole_ = Json::parse(
        read_text_file(std::string(ARTCAL_SOURCE_DIR) + "/tests/reference/results-schema-1/identification.json",
                       1 << 24)
            ->text);
    ASSERT_TRUE(bring_up_to_date(whole_));
  }
  static RecordedIdentification read(const Json& json) { return recorded_identification(RecordedObject(json)); }
  static std::string refusal(const Json& json) {
    try {
      (void)read(json);
    } catch (const NotAsInSchema& reason) {
      return reason.what();
    }
    return "read";
  }
  static inline Json whole_;
};

TEST_F(RecordedIdentificationTest, HasItsParts) {
  const RecordedIdentification read = RecordedIdentificationTest::read(whole_);
  ASSERT_EQ(read.parameters.size(), whole_["parameters"].size());
  std::size_t identified = 0;
  for (std::size_t i = 0; i < read.parameters.size(); ++i) {
    const Json& json = whole_["parameters"][i];
    EXPECT_EQ(read.parameters[i].name, json["name"]);
    EXPECT_EQ(read.parameters[i].nominal, json["nominal"]);
    EXPECT_EQ(read.parameters[i].identified, json["identified"]);
    if (read.parameters[i].is_identified()) {
      EXPECT_EQ(read.parameters[i].u, json["standard_uncertainty"]);
      ++identified;
    }
  }
  EXPECT_EQ(static_cast<std::size_t>(read.covariance.matrix.rows()), identified);
  EXPECT_EQ(read.covariance.matrix(3, 1), whole_["covariance"]["matrix"][3][1]);
  EXPECT_EQ(read.noise.noise, whole_["noise"]["mm"]);
  EXPECT_EQ(read.noise.is_given, whole_["noise"]["given"]);
  EXPECT_EQ(read.noise.chi_squared_high, whole_["noise"]["chi_squared_95"][1]);
  EXPECT_EQ(read.noise.scale_factor, whole_["noise"]["scale_factor"]);
  ASSERT_TRUE(read.cross_validation);
  EXPECT_EQ(read.cross_validation->ratio_99, whole_["cross_validation"]["ratio_99"]);
  EXPECT_EQ(read.identifiability.rank, whole_["coupling"]["rank"]);
  EXPECT_EQ(read.identifiability.unidentifiable.front().fixed, whole_["coupling"]["unidentifiable"][0]["fixed"]);
  EXPECT_EQ(read.after.overall.rms, whole_["after"]["overall"]["rms_mm"]);
  EXPECT_EQ(read.outliers.front().standardised, whole_["outliers"][0]["standardised"]);
  EXPECT_TRUE(read.outliers.front().is_signed) << "that version did not say";
  EXPECT_EQ(read.circumstances.readings, 387u);
}

TEST_F(RecordedIdentificationTest, MayLackWhatEarlierVersionsDidNotHave) {
  Json old = whole_;
  old.erase("cross_validation");
  old.erase("residuals");
  const RecordedIdentification read = RecordedIdentificationTest::read(old);
  EXPECT_FALSE(read.cross_validation);
  EXPECT_FALSE(read.readings);
}

// A covariance in another order would give each parameter the uncertainty of its neighbour.
TEST_F(RecordedIdentificationTest, IsRefusedWhereTheCovarianceIsOfOtherParameters) {
  const std::string refused = "covariance.parameters is not the list of the identified parameters in their order";
  Json other = whole_;
  Json& names = other["covariance"]["parameters"];
  std::swap(names[0], names[1]);
  EXPECT_EQ(refusal(other), refused);
  other = whole_;
  other["parameters"][other["parameters"].size() - 1]["name"] = "zz";
  other["covariance"]["parameters"][0] = "zz";
  EXPECT_EQ(refusal(other), refused);
}

TEST_F(RecordedIdentificationTest, IsRefusedWherePartsDoNotFit) {
  Json other = whole_;
  other["coupling"]["unidentifiable"][0]["motion"]["b6"] = 1;
  EXPECT_EQ(refusal(other), "coupling.unidentifiable is a motion of \"b6\", expected a parameter");
  other = whole_;
  other["before"]["placements"].erase(0);
  EXPECT_EQ(refusal(other), "after.placements is a list of 6, expected 5 as in before");
  other = whole_;
  other["noise"]["chi_squared_95"] = {1.0};
  EXPECT_EQ(refusal(other), "noise.chi_squared_95 is a list of 1, expected two numbers");
  other = whole_;
  other["parameters"][2]["state"] = "lost";
  EXPECT_EQ(refusal(other), "parameters[2].state is \"lost\", expected identified, weak, fixed or unidentifiable");
  other = whole_;
  other["cross_validation"] = {{"placements", 6}, {"ratio", "much"}};
  EXPECT_EQ(refusal(other), "cross_validation.ratio is a text, expected a number");
}

}  // namespace
}  // namespace artcal
