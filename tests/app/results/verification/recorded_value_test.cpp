#include "app/results/verification/recorded_value.h"

#include <cmath>

#include <gmock/gmock.h>

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json place() {
  return {{"point_mm", {1.0, 2.0, 3.0}},
          {"octant", 7},
          {"share_of_reach", 0.5},
          {"above_base", true},
          {"joint_at_stop", nullptr}};
}

// A length as docs/result-schema.md has it.
Json length() {
  return {{"quantity", "E_Uni"},
          {"artefact", "bar"},
          {"placement", "3"},
          {"first", "A"},
          {"second", "B"},
          {"repeat", ""},
          {"certified_mm", 500.0},
          {"stated_mm", 500.1},
          {"stated_at_C", 21.0},
          {"measured_mm", 500.02},
          {"value_mm", -0.02},
          {"temperature_C", nullptr},
          {"limit_mm", 0.04},
          {"u_mm", 0.003},
          {"budget",
           {{"calibration_mm", 0.001},
            {"expansion_mm", 0.0},
            {"temperature_mm", 0.0},
            {"alignment_mm", 0.0},
            {"fixture_mm", 0.002},
            {"form_mm", 0.0},
            {"points_mm", 0.0005}}},
          {"verdict", "does_not_conform"},
          {"set_aside", false},
          {"place", place()}};
}

RecordedValue read(const Json& value) {
  Json verification;
  verification["values"].push_back(value);
  return recorded_values(RecordedObject(verification)).at(0);
}

TEST(RecordedValues, AreReadWithTheirTypes) {
  const RecordedValue value = read(length());
  EXPECT_TRUE(value.is_length());
  EXPECT_EQ(value.certified, 500.0);
  EXPECT_EQ(value.stated, 500.1);
  EXPECT_TRUE(std::isnan(value.temperature));
  EXPECT_EQ(value.severity(), 0.5) << "0.02 of 0.04 mm";
  EXPECT_EQ(value.verdict, Verdict::NonConformityProven);
  EXPECT_EQ(value.budget.value().fixture, 0.002);
  EXPECT_EQ(value.place.point_in_base, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(value.place.joint_at_stop, 0);
}

// Of earlier versions, and of a seat without a certified value or a limit.
TEST(RecordedValues, MayLackWhatTheirVersionDidNotHave) {
  Json old = length();
  old.erase("stated_mm");
  old.erase("stated_at_C");
  old["budget"].erase("points_mm");
  old["second"] = nullptr;
  old["certified_mm"] = nullptr;
  old["limit_mm"] = nullptr;
  const RecordedValue value = read(old);
  EXPECT_FALSE(value.is_length());
  EXPECT_FALSE(value.certified);
  EXPECT_TRUE(std::isnan(value.stated));
  EXPECT_EQ(value.severity(), 0.02);
  EXPECT_EQ(value.budget.value().points, 0.0);
}

std::string refusal(const Json& value) {
  try {
    (void)read(value);
  } catch (const NotAsInSchema& reason) {
    return reason.what();
  }
  return "read";
}

TEST(RecordedValues, AreRefusedByThePlaceOfWhatIsWrong) {
  Json broken = length();
  broken.erase("value_mm");
  EXPECT_EQ(refusal(broken), "values[0].value_mm is missing, expected a number");
  broken = length();
  broken["verdict"] = 3;
  EXPECT_EQ(refusal(broken), "values[0].verdict is 3, expected a text");
  broken = length();
  broken["place"]["octant"] = 1e12;
  EXPECT_EQ(refusal(broken), "values[0].place.octant is 1000000000000.0, expected a whole number");
  broken = length();
  broken["quantity"] = "E_Tri";
  EXPECT_THAT(refusal(broken), ::testing::StartsWith("values[0].quantity is \"E_Tri\", expected P_Size"));
}

}  // namespace
}  // namespace artcal
