// `artcal segment` as a person runs it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class Segment : public testing::ProgramTest {
 protected:
  Segment() { take("ball-bar-scan"); }

  [[nodiscard]] Ended segment(std::vector<std::string> more, const std::string& unit = "mm",
                              const std::string& artefact = "ball-bar-scan/bar.toml") const {
    std::vector<std::string> arguments{"segment", "ball-bar-scan/scan.xyz", "--artefact", artefact, "--unit", unit};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  // The bar's file with one text in place of another.
  void change(const std::string& from, const std::string& to) const {
    std::string text = text_of("ball-bar-scan/bar.toml");
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    write("other.toml", text.replace(at, from.size(), to));
  }
};

// The head of the scan says where its balls truly are.
TEST_F(Segment, FindsTheBallsWhereTheyAre) {
  const Ended ended = segment({"--json", "-"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  ASSERT_EQ(json["spheres"].size(), 3u);
  std::istringstream lines(text_of("ball-bar-scan/scan.xyz"));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  for (const auto& sphere : json["spheres"]) {
    std::getline(lines, line);
    std::istringstream words(line.substr(1));
    for (int axis = 0; axis < 3; ++axis) {
      double truth = 0.0;
      words >> truth;
      EXPECT_NEAR(sphere["centre_mm"][axis].get<double>(), truth, 4.0 * sphere["u_centre_mm"][axis].get<double>());
    }
    EXPECT_NEAR(sphere["noise_mm"].get<double>(), 0.025, 0.002);
  }
  for (const auto& distance : json["distances"]) {
    EXPECT_LT(std::abs(distance["error_mm"].get<double>()), 0.01);
  }
  EXPECT_EQ(json["rejected"][0]["reason"], "stray");
}

TEST_F(Segment, RowsAreThoseThatAFitTakes) {
  const auto json = nlohmann::json::parse(segment({"--json", "-"}).out);
  std::string rows;
  for (const auto& row : json["spheres"][1]["rows"]) rows += std::to_string(row.get<int>()) + "\n";
  write("rows.txt", rows);
  const Ended fit = run({"fit", "ball-bar-scan/scan.xyz", "--shape", "sphere", "--diameter", "25.4 mm", "--unit", "mm",
                         "--rows", "rows.txt", "--json", "-"});
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  int compared = 0;
  const auto result = nlohmann::json::parse(fit.out);
  for (const auto& value : result["values"]) {
    for (int axis = 0; axis < 3; ++axis) {
      if (value["name"] == std::string("centre ") + "xyz"[axis]) {
        EXPECT_NEAR(value["value"].get<double>(), json["spheres"][1]["centre_mm"][axis].get<double>(), 1e-9);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 3);
}

TEST_F(Segment, TellsAPerson) {
  const Ended ended = segment({});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.out, HasSubstr("ball bar 300"));
  EXPECT_THAT(ended.out, HasSubstr("x, y, z from columns 1, 2, 3 of 3, without a header"));
  EXPECT_THAT(ended.out, HasSubstr("A - C      300.0307"));
  EXPECT_THAT(ended.out, HasSubstr("at no certified distance from the others"));
  EXPECT_THAT(segment({"--quiet"}).out, IsEmpty());
}

TEST_F(Segment, TwiceTheSameBytes) { EXPECT_EQ(segment({"--json", "-"}).out, segment({"--json", "-"}).out); }

TEST_F(Segment, WhatCannotBeToldIsNotGuessed) {
  // Equal distances: turned round, the bar looks the same.
  change("180.0213", "150.0151");
  std::string text = text_of("other.toml");
  text.replace(text.find("120.0094"), 8, "150.0156");
  write("other.toml", text);
  const Ended ended = segment({"--tolerance", "31 mm", "--json", "result.json"}, "mm", "other.toml");
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_THAT(ended.err, HasSubstr("ways"));
  EXPECT_THAT(ended.err, HasSubstr("--place"));
  EXPECT_THAT(names(), Not(::testing::Contains("result.json")));
  const Ended told = segment({"--tolerance", "31 mm", "--place", "A=412.5,-230,151", "--place", "B=402.1,-73.4,239.1"},
                             "mm", "other.toml");
  EXPECT_EQ(told.exit_code, 0) << told.err;
}

// Not the nearest ball, however far.
TEST_F(Segment, APlaceWithoutABallIsRefused) {
  const Ended ended = segment({"--place", "A=412.5,-30,151"});
  EXPECT_EQ(ended.exit_code, 4) << ended.out;
  EXPECT_THAT(ended.err, HasSubstr("--place states \"A\" at (412.5, -30.0, 151.0) mm, but no sphere was found within"));
  EXPECT_THAT(ended.err, HasSubstr("the nearest is"));
}

TEST_F(Segment, AMissingBallIsNamed) {
  std::string text =
      text_of("ball-bar-scan/bar.toml") + "\n[[feature]]\nname = \"D\"\nkind = \"sphere\"\ndiameter = 25.4\n";
  for (const auto& [from, value] : {std::pair("A", "377.0307"), std::pair("B", "197.0094"), std::pair("C", "77.0")}) {
    text += fmt::format("[[distance]]\nbetween = [\"{}\", \"D\"]\nvalue = {}\nU = 0.001\nk = 2\n", from, value);
  }
  write("other.toml", text);
  const Ended ended = segment({}, "mm", "other.toml");
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("Missing in this scan: D"));
}

TEST_F(Segment, TheWrongUnitIsSaid) {
  const Ended ended = segment({}, "m");
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_THAT(ended.err, HasSubstr("millimetres read as metres"));
}

TEST_F(Segment, TheWrongArtefactIsSaid) {
  change("value = 180.0213", "value = 185.0213");
  const Ended contradiction = segment({}, "mm", "other.toml");
  EXPECT_NE(contradiction.exit_code, 0);
  std::string text = text_of("ball-bar-scan/bar.toml");
  for (std::size_t at = text.find("25.4"); at != std::string::npos; at = text.find("25.4", at + 4)) {
    text.replace(at, 4, "30.0");
  }
  write("other.toml", text);
  const Ended radius = segment({}, "mm", "other.toml");
  EXPECT_EQ(radius.exit_code, 4);
  EXPECT_THAT(radius.err, HasSubstr("none of the artefact's features was found"));
}

TEST_F(Segment, WrongCallsAreRefused) {
  EXPECT_EQ(segment({}, "furlong").exit_code, 2);
  EXPECT_EQ(segment({"--tolerance", "5"}).exit_code, 2);
  EXPECT_EQ(segment({"--tolerance", "-1 mm"}).exit_code, 2);
  EXPECT_EQ(segment({"--temperature", "nan"}).exit_code, 2);
  EXPECT_EQ(segment({"--radius", "any"}).exit_code, 2);
  for (const char* place : {"A", "A=1,2", "A=1,2,3,4", "A=1,2,x", "Z=1,2,3", "A=1,2,nan", "=1,2,3"}) {
    const Ended ended = segment({"--place", place});
    EXPECT_EQ(ended.exit_code, 2) << place;
    EXPECT_THAT(ended.err, HasSubstr("--place")) << place;
  }
  EXPECT_EQ(run({"segment", "ball-bar-scan/scan.xyz", "--artefact", "ball-bar-scan/bar.toml"}).exit_code, 2);
  EXPECT_EQ(run({"segment", "nowhere.xyz", "--artefact", "ball-bar-scan/bar.toml", "--unit", "mm"}).exit_code, 3);
  EXPECT_EQ(segment({"--json", "ball-bar-scan/scan.xyz"}).exit_code, 2);
}

}  // namespace
}  // namespace artcal
