// `artcal fit`: what it prints, writes, refuses.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/files/hash.h"
#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::json;

class Fit : public testing::ProgramTest {
 protected:
  Fit() { take("points"); }

  [[nodiscard]] Ended fit(const std::string& points, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"fit", points};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  void expect_refusal(const Ended& ended, int exit_code, const std::string& sentence) const {
    EXPECT_EQ(ended.exit_code, exit_code) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(sentence));
    EXPECT_THAT(ended.out, IsEmpty());
  }
};

const std::string ball = "points/ball.xyz";
const std::string scan = "points/ball-scan.pcd";

// Planted: centre (312.4182, -145.0071, 88.2365), 25.4 mm and a tip of 6 mm, noise 2 µm.
TEST_F(Fit, TellsATechnicianWhatCameOut) {
  const Ended ended = fit(ball, {"--shape", "sphere", "--unit", "mm", "--tip-diameter", "6 mm"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_THAT(ended.out,
              HasSubstr("points/ball.xyz\nsphere, least-squares, outside by a tip of 6 mm: 25 of 25 points\n"));
  EXPECT_THAT(ended.out, ContainsRegex("centre x +mm +312\\.41[89][0-9]* +0\\.000"));
  EXPECT_THAT(ended.out, ContainsRegex("diameter +mm +25\\.39[0-9]+ +0\\.001"));
  EXPECT_THAT(ended.out, ContainsRegex("form +mm +0\\.00"));
  EXPECT_THAT(ended.out, HasSubstr("estimated with 21 degrees of freedom"));
  EXPECT_THAT(names(), ElementsAre("points"));
}

TEST_F(Fit, WritesTheResult) {
  const Ended ended =
      fit(scan, {"--shape", "sphere", "--unit", "m", "--diameter", "25.4mm", "--robust", "--json", "r.json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Json json = Json::parse(text_of("r.json"));
  EXPECT_EQ(json["inputs"][0]["sha256"], sha256(text_of(scan)));
  const double truth[] = {412.37, 208.11, 150.32};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Json& value = json["values"][axis];
    EXPECT_NEAR(value["value"].get<double>(), truth[axis], 4.0 * value["standard_uncertainty"].get<double>());
  }
  EXPECT_EQ(json["values"][3]["value"], 25.4);
  EXPECT_TRUE(json["values"][3]["standard_uncertainty"].is_null()) << "it was stated, not found";
  EXPECT_EQ(json["counts"], Json({{"records", 600}, {"dropped", 3}, {"fitted", 586}, {"outliers", 11}}));
  // Every 53rd row was spoiled, every 151st is no number.
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(json["outliers"][i]["row"], 53 * (i + 1) - 1);
  }
  EXPECT_THAT(ended.out, HasSubstr("Left out as outliers: 11 of 597 points\n  row 52: -1.56319 mm"));
  EXPECT_THAT(ended.out, HasSubstr("Warning: 3 of 600 points are NaN"));
}

TEST_F(Fit, EachShape) {
  write("plane.xyz", "0 0 1\n10 0 1\n0 10 1\n10 10 1.001\n5 5 1\n");
  write("line.xyz", "0 0 0\n1 1 1\n2 2 2\n3 3 3.001\n");
  write("circle.csv", "x,y,z\n1,0,5\n0,1,5\n-1,0,5\n0,-1.001,5\n");
  std::string cylinder = "# across z, radius 2\n", cone;
  for (int i = 0; i < 24; ++i) {
    const double angle = 0.6 * i;
    const double height = i % 5;
    const auto row = [&](double radius) {
      return std::to_string(radius * std::cos(angle)) + " " + std::to_string(radius * std::sin(angle)) + " " +
             std::to_string(height) + "\n";
    };
    cylinder += row(2.0);
    cone += row(1.0 + 0.5 * height);
  }
  write("cylinder.xyz", cylinder);
  write("cone.xyz", cone);
  for (const auto& [shape, file, line] : {std::tuple("plane", "plane.xyz", "normal z +1 +0\\.99999999"),
                                          std::tuple("line", "line.xyz", "direction x +1 +0\\.577"),
                                          std::tuple("circle", "circle.csv", "diameter +mm +2\\.00"),
                                          std::tuple("cylinder", "cylinder.xyz", "diameter +mm +4\\.00000"),
                                          std::tuple("cone", "cone.xyz", "apex angle +deg +53\\.1301")}) {
    const Ended ended = fit(file, {"--shape", shape, "--unit", "mm"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, ContainsRegex(line)) << shape;
  }
  EXPECT_THAT(fit("cone.xyz", {"--shape", "cone", "--unit", "mm"}).out, ContainsRegex("apex z +mm +-2\\.0000"));
  EXPECT_THAT(fit(ball, {"--shape", "sphere", "--unit", "mm", "--criterion", "minimum-zone"}).out,
              HasSubstr("no uncertainty: the answer rests on the few outermost points"));
}

TEST_F(Fit, OnlyTheListedRows) {
  write("rows.txt", "# the equator\n17\n18\n\n19\n24\r\n20\n");
  const Ended ended = fit(ball, {"--shape", "circle", "--unit", "mm", "--rows", "rows.txt", "--json", "-"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Json json = Json::parse(ended.out);
  EXPECT_EQ(json["counts"]["fitted"], 5);
  EXPECT_EQ(json["inputs"][1]["path"], "rows.txt");
  EXPECT_GE(json["lowest"]["row"], 17);
  for (const auto& [rows, sentence] :
       {std::pair("3\nfour\n", "rows.txt:2: found \"four\", expected the number of a row, from 0"),
        std::pair("-1\n", "found \"-1\""), std::pair("25\n", "row 25 is not among the 25 points"),
        std::pair("3\n4\n3\n", "row 3 is listed twice"), std::pair("# none\n", "the list names no row")}) {
    write("rows.txt", rows);
    expect_refusal(fit(ball, {"--shape", "sphere", "--unit", "mm", "--rows", "rows.txt"}), 3, sentence);
  }
}

TEST_F(Fit, AWrongUnitIsSaid) {
  for (const char* unit : {"mm", "in", "um"}) {
    expect_refusal(fit(scan, {"--shape", "sphere", "--unit", unit, "--diameter", "25.4mm", "--robust"}), 3,
                   "but 25.4 mm are stated: the coordinates look like m; check --unit");
  }
  expect_refusal(fit(ball, {"--shape", "sphere", "--unit", "m", "--diameter", "31.4mm"}), 3,
                 "look like mm; check --unit");
  expect_refusal(fit(ball, {"--shape", "sphere", "--unit", "mm", "--diameter", "314mm"}), 3, "look like cm");
  expect_refusal(fit(ball, {"--shape", "sphere", "--unit", "mm", "--diameter", "25mm"}), 3,
                 "on a sphere of diameter 31.3983 mm when read in mm, but 25 mm are stated; check --diameter");
  EXPECT_THAT(fit(ball, {"--shape", "sphere", "--unit", "mm", "--diameter", "31.5mm"}).out,
              HasSubstr("Warning: left free, the diameter comes out as 31.39832 mm, -0.10168 mm from the stated one"));
}

TEST_F(Fit, WrongUsageIsExplained) {
  const auto refused = [&](const std::vector<std::string>& more, const std::string& sentence) {
    expect_refusal(fit(ball, more), 2, sentence);
  };
  refused({"--shape", "sphere"},
          "--unit is missing, expected artcal fit [OPTIONS] POINTS --unit …; see artcal fit --help");
  refused({"--shape", "sphere", "--unit", "furlong"}, "--unit: found \"furlong\", expected the unit");
  refused({"--shape", "cube", "--unit", "mm"},
          "--shape is \"cube\", expected sphere, plane, line, circle, cylinder or cone");
  refused({"--shape", "sphere", "--unit", "mm", "--diameter", "25.4"}, "--diameter: found \"25.4\", expected a length");
  refused({"--shape", "sphere", "--unit", "mm", "--tip-diameter", "0 mm"}, "--tip-diameter: found \"0 mm\"");
  refused({"--shape", "sphere", "--unit", "mm", "--noise", "-3um"}, "--noise: found");
  refused({"--shape", "plane", "--unit", "mm", "--diameter", "1mm"}, "a fixed radius is for a sphere");
  refused({"--shape", "plane", "--unit", "mm", "--tip-diameter", "1mm"}, "needs the direction");
  refused({"--shape", "line", "--unit", "mm", "--criterion", "minimum-zone"}, "there is no minimum zone line");
  refused({"--shape", "sphere", "--unit", "mm", "--criterion", "minimum-zone", "--robust"},
          "a robust fit is a least-squares fit");
  refused({"--shape", "sphere", "--unit", "mm", "--inside"}, "state its --tip-diameter");
  refused({"--shape", "sphere", "--unit", "mm", "--spatial"}, "--spatial is for a circle");
  refused({"--shape", "sphere", "--unit", "mm", "--towards", "1,2"}, "expected three");
  refused({"--shape", "sphere", "--unit", "mm", "--json", ball}, "is an input of this result");
}

// A bore of radius 9 touched at heights that tilt the plane through its points.
TEST_F(Fit, ACircleWithAKnownNormal) {
  std::string points;
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.5 * i;
    points += std::to_string(40.0 + 9.0 * std::cos(angle)) + " " + std::to_string(9.0 * std::sin(angle)) + " " +
              std::to_string(3.0 * std::cos(angle)) + "\n";
  }
  write("bore.xyz", points);
  const Ended known = fit("bore.xyz", {"--shape", "circle", "--unit", "mm", "--normal=0,0,1"});
  EXPECT_EQ(known.exit_code, 0) << known.err;
  EXPECT_THAT(known.out, HasSubstr("circle, least-squares, normal as stated"));
  EXPECT_THAT(known.out, ContainsRegex("diameter +mm +18\\.0000"));
  EXPECT_THAT(fit("bore.xyz", {"--shape", "circle", "--unit", "mm"}).out, Not(ContainsRegex("diameter +mm +18\\.0")));
  for (const auto& [more, sentence] :
       {std::pair(std::vector<std::string>{"--shape", "plane", "--normal=0,0,1"}, "--normal is for a circle"),
        std::pair(std::vector<std::string>{"--shape", "circle", "--normal=0,0"}, "expected three"),
        std::pair(std::vector<std::string>{"--shape", "circle", "--normal=0,0,0"}, "zero"),
        std::pair(std::vector<std::string>{"--shape", "circle", "--normal=0,0,1", "--spatial"},
                  "leave one of them out")}) {
    auto all = more;
    all.insert(all.end(), {"--unit", "mm"});
    expect_refusal(fit("bore.xyz", all), 2, sentence);
  }
}

TEST_F(Fit, SaysWhichColumnsItRead) {
  EXPECT_THAT(fit(ball, {"--shape", "sphere", "--unit", "mm"}).out,
              HasSubstr("x, y, z from columns 1, 2, 3 of 3, without a header\n"));
  write("t.csv", "3.00,0.5,0,0.8\n3.05,0,0.5,0.8\n3.10,-0.5,0,0.8\n3.15,0,-0.5,0.8\n3.20,0.3,0.4,0.8\n");
  expect_refusal(fit("t.csv", {"--shape", "circle", "--unit", "m"}), 3, "t.csv: there are 4 columns without a header");
  const Ended told = fit("t.csv", {"--shape", "circle", "--unit", "m", "--columns", "2,3,4", "--json", "-"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  const Json json = Json::parse(told.out);
  EXPECT_EQ(json["columns"], "columns 2, 3, 4 of 4, as stated");
  for (const Json& value : json["values"]) {
    if (value["name"] == "diameter") {
      EXPECT_NEAR(value["value"].get<double>(), 1000.0, 1e-6);
    }
  }
  for (const char* columns : {"2,3", "0,1,2", "2,2,3"}) {
    expect_refusal(fit("t.csv", {"--shape", "circle", "--unit", "m", "--columns", columns}), 2, "--columns");
  }
}

// What would be passed over in silence is refused.
TEST_F(Fit, OptionsThatCannotBe) {
  const auto refused = [&](const std::vector<std::string>& more, const std::string& sentence) {
    auto all = more;
    all.insert(all.end(), {"--unit", "mm"});
    expect_refusal(fit(ball, all), 2, sentence);
  };
  refused({"--shape", "sphere", "--diameter", "10 mm", "--tip-diameter", "10 mm", "--inside"}, "does not fit inside");
  refused({"--shape", "plane", "--tip-diameter", "1 mm", "--inside"}, "a plane has no inside");
  refused({"--shape", "cone", "--towards", "0,0,1"}, "no meaning for a cone");
  refused({"--shape", "sphere", "--towards", "0,0,1"}, "only together with its --diameter");
  refused({"--shape", "circle", "--criterion", "minimum-zone", "--noise", "1 um"}, "--noise belongs to least squares");
}

TEST_F(Fit, WhatThePointsDoNotTellIsNoSolution) {
  write("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0.5 0.2 0\n");
  expect_refusal(fit("flat.xyz", {"--shape", "sphere", "--unit", "mm"}), 4, "flat.xyz: ");
  write("few.xyz", "0 0 0\n1 0 0\n");
  expect_refusal(fit("few.xyz", {"--shape", "plane", "--unit", "mm"}), 3, "few.xyz: ");
  write("cut.pcd", text_of(scan).substr(0, 5000));
  expect_refusal(fit("cut.pcd", {"--shape", "sphere", "--unit", "m"}), 3,
                 "cut.pcd: the header promises 600 points of 24");
  EXPECT_THAT(names(), Not(::testing::Contains("r.json")));
}

TEST_F(Fit, QuietAndJsonKeepStandardOutputClean) {
  EXPECT_THAT(fit(ball, {"--shape", "sphere", "--unit", "mm", "-q"}).out, IsEmpty());
  const Ended ended = fit(ball, {"--shape", "sphere", "--unit", "mm", "--json", "-"});
  EXPECT_EQ(Json::parse(ended.out)["kind"], "fit");
  EXPECT_THAT(fit(ball, {"--shape", "sphere", "--unit", "mm", "--json", "no/such/r.json"}).err,
              HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace artcal
