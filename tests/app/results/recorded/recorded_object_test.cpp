// What a hostile or damaged result may hold in the place of a value: refused by its place, never read as another value.
#include "app/results/recorded/recorded_object.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

std::string refusal(const std::string& text, const std::function<void(const RecordedObject&)>& read) {
  const Json json = Json::parse(text);
  try {
    read(RecordedObject(json, "noise"));
  } catch (const NotAsInSchema& reason) {
    return reason.what();
  }
  return "read";
}

TEST(RecordedObject, ReadsEachKind) {
  const Json json = Json::parse(R"({"text": "a", "number": 2, "truth": true, "count": 18446744073709551615,
      "minus": -2147483648, "null": null, "point": [1, 2.5, -3], "numbers": [1, null], "rows": [[1, 2], [3, 4]],
      "motion": {"a6": 1, "theta6": -0.25}, "list": [{"x": 1}, {"x": 2}]})");
  const RecordedObject object(json);
  EXPECT_EQ(object.text("text"), "a");
  EXPECT_EQ(object.number("number"), 2.0);
  EXPECT_TRUE(object.truth("truth"));
  EXPECT_EQ(object.count("count"), 18446744073709551615u);
  EXPECT_EQ(object.integer("minus"), -2147483647 - 1);
  EXPECT_EQ(object.point("point"), Eigen::Vector3d(1.0, 2.5, -3.0));
  EXPECT_EQ(object.square_matrix("rows", 2), (Eigen::Matrix2d() << 1, 2, 3, 4).finished()) << "by rows";
  EXPECT_EQ(object.numbers_by_name("motion")[1], std::pair(std::string("theta6"), -0.25));
  EXPECT_EQ(object.list("list", [](const RecordedObject& each) { return each.integer("x"); }),
            (std::vector<int>{1, 2}));
  EXPECT_TRUE(std::isnan(object.number_or_nan("null")));
  EXPECT_TRUE(std::isnan(object.numbers_or_nan("numbers")[1]));
  EXPECT_FALSE(object.has("null") || object.has("absent"));
  EXPECT_EQ(object.text_or("null", "-") + object.text_or("absent", "-"), "--");
  EXPECT_EQ(object.optional_number("null"), std::nullopt);
  EXPECT_TRUE(object.truth_or("absent", true));
}

TEST(RecordedObject, RefusesWhatIsMissingOrOfAnotherKind) {
  const auto number = [](const RecordedObject& object) { (void)object.number("mm"); };
  EXPECT_EQ(refusal("{}", number), "noise.mm is missing, expected a number");
  EXPECT_EQ(refusal(R"({"mm": "1"})", number), "noise.mm is a text, expected a number");
  EXPECT_EQ(refusal(R"({"mm": null})", number), "noise.mm is null, expected a number");
  EXPECT_EQ(refusal(R"({"mm": true})", number), "noise.mm is true or false, expected a number");
  EXPECT_EQ(refusal("[]", number), "noise is a list, expected an object");
  EXPECT_EQ(refusal("{}", [](const RecordedObject& object) { (void)object.number_or_nan("mm"); }),
            "noise.mm is missing, expected a number");
  EXPECT_EQ(refusal(R"({"mm": 7})", [](const RecordedObject& object) { (void)object.text_or("mm"); }),
            "noise.mm is 7, expected a text");
  EXPECT_EQ(refusal(R"({"mm": {"u": 7}})", [](const RecordedObject& object) { (void)object.object("mm").truth("u"); }),
            "noise.mm.u is 7, expected true or false");
}

// A double out of the range of an integer has no defined value as one.
TEST(RecordedObject, RefusesNumbersThatAreNoCounts) {
  const auto integer = [](const RecordedObject& object) { (void)object.integer("n"); };
  const auto count = [](const RecordedObject& object) { (void)object.count("n"); };
  for (const char* text : {"1e300", "2.5", "2147483648", "-2147483649", "18446744073709551615"}) {
    EXPECT_EQ(refusal(R"({"n": )" + std::string(text) + "}", integer).substr(0, 11), "noise.n is ") << text;
  }
  EXPECT_EQ(refusal(R"({"n": -1})", count), "noise.n is -1, expected a whole number, 0 or more");
  EXPECT_EQ(refusal(R"({"n": 1e300})", count), "noise.n is 1e+300, expected a whole number, 0 or more");
  EXPECT_EQ(refusal(R"({"n": [0, -1]})", [](const RecordedObject& object) { (void)object.counts("n"); }),
            "noise.n[1] is -1, expected a whole number, 0 or more");
}

TEST(RecordedObject, RefusesListsByTheElement) {
  EXPECT_EQ(refusal(R"({"p": [1, 2]})", [](const RecordedObject& object) { (void)object.point("p"); }),
            "noise.p is a list of 2, expected x, y, z");
  EXPECT_EQ(
      refusal(R"({"p": [[1, 2, 3], [1, 2, "3"]]})", [](const RecordedObject& object) { (void)object.points("p"); }),
      "noise.p[1][2] is a text, expected a number");
  EXPECT_EQ(refusal(R"({"t": ["a", 1]})", [](const RecordedObject& object) { (void)object.texts("t"); }),
            "noise.t[1] is 1, expected a text");
  EXPECT_EQ(
      refusal(R"({"m": [[1, 2], [3]]})", [](const RecordedObject& object) { (void)object.square_matrix("m", 2); }),
      "noise.m[1] is of 1 numbers, expected 2");
  EXPECT_EQ(refusal(R"({"m": [[1]]})", [](const RecordedObject& object) { (void)object.square_matrix("m", 2); }),
            "noise.m is of 1 rows, expected 2");
  EXPECT_EQ(
      refusal(R"({"m": {"a\n6": null}})", [](const RecordedObject& object) { (void)object.numbers_by_name("m"); }),
      "noise.m[\"a?6\"] is null, expected a number")
      << "a name from a file obeys no terminal";
  const auto x_of_each = [](const RecordedObject& object) {
    (void)object.list("l", [](const RecordedObject& each) { return each.integer("x"); });
  };
  EXPECT_EQ(refusal(R"({"l": [{"x": 1}, {}]})", x_of_each), "noise.l[1].x is missing, expected a whole number");
  EXPECT_EQ(refusal(R"({"l": [{"x": 1}, 2]})", x_of_each), "noise.l[1] is 2, expected an object");
  EXPECT_EQ(refusal(R"({"l": {"x": 1}})", x_of_each), "noise.l is an object, expected a list");
}

}  // namespace
}  // namespace artcal
