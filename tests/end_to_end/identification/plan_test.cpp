// `artcal plan`: what it takes, writes and refuses.
#include <array>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>
#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

class PlanCommand : public testing::ProgramTest {
 protected:
  void SetUp() override { take("ball-bar"); }
  Ended plan(std::vector<std::string> more) {
    std::vector<std::string> words{
        "plan", "ball-bar/arm.toml", "--artefact", "ball-bar/bar.toml", "--possible", "8",           "--postures",
        "8",    "--readings",        "6",          "--encoder-noise",   "2 arcsec",   "--placements"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(PlanCommand, WritesATableAndAPicture) {
  const Ended ended = plan({"3", "--probing-noise", "3 um", "-o", "plan.csv", "--picture", "plan.svg"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("3 of 8 possible placements"), HasSubstr("with this plan")));
  const std::string table = text_of("plan.csv");
  EXPECT_THAT(
      table,
      StartsWith("placement,artefact,feature,q1,q2,q3,q4,q5,q6,x_mm,y_mm,z_mm,turn_x_deg,turn_y_deg,turn_z_deg\n"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 3 * 4 * 6);  // four balls
  EXPECT_THAT(text_of("plan.svg"), AllOf(StartsWith("<svg "), HasSubstr("<title>"), HasSubstr("</svg>")));
}

TEST_F(PlanCommand, ProposesOnlyWhatTheStandHolds) {
  const std::vector<std::string> asked{"3",       "--probing-noise", "3 um",      "--floor",
                                       "-150 mm", "--highest",       "600 mm",    "--table=-200,900,-200,200,300",
                                       "--json",  "plan.json",       "--picture", "plan.svg"};
  const Ended ended = plan(asked);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Json json = Json::parse(text_of("plan.json"));
  ASSERT_EQ(json["chosen"].size(), 3u);
  for (const Json& chosen : json["chosen"]) {
    std::vector<Eigen::Vector3d> ends;
    for (const char* end : {"first_feature_mm", "last_feature_mm"}) {
      const auto at = chosen[end].get<std::array<double, 3>>();
      ends.emplace_back(at[0], at[1], at[2]);
    }
    for (int i = 0; i <= 1000; ++i) {  // along the bar
      const Eigen::Vector3d at = ends[0] + 0.001 * i * (ends[1] - ends[0]);
      EXPECT_GT(at.z(), -150.0);
      EXPECT_LT(at.z(), 600.0);
      EXPECT_FALSE(at.x() > -200.0 && at.x() < 900.0 && at.y() > -200.0 && at.y() < 200.0 && at.z() < 300.0)
          << at.transpose();
    }
  }
  EXPECT_EQ(json["stand"]["floor_mm"], -150.0);
  EXPECT_THAT(text_of("plan.svg"), AllOf(HasSubstr(">floor</text>"), HasSubstr("class=\"table\"")));
  const Ended none = plan({"2", "--probing-noise", "3 um", "--lowest", "20 m"});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_THAT(none.err, AllOf(HasSubstr("keeps to the limits of the stand"), HasSubstr("below the lowest")));
  EXPECT_EQ(plan({"2", "--probing-noise", "3 um", "--lowest", "1 m", "--highest", "0.5 m"}).exit_code, 2);
  EXPECT_THAT(plan({"2", "--probing-noise", "3 um", "--floor", "-700"}).err, HasSubstr("\"-700 mm\""));
  EXPECT_THAT(plan({"2", "--probing-noise", "3 um", "--table", "1,2,3"}).err, HasSubstr("X1,X2,Y1,Y2,TOP"));
}

// The pose of a row puts the artefact where the JSON has its ends.
TEST_F(PlanCommand, TheTableHasThePoseOfEachPlacement) {
  ASSERT_EQ(plan({"2", "--probing-noise", "3 um", "-o", "plan.csv", "--json", "plan.json"}).exit_code, 0);
  const Json json = Json::parse(text_of("plan.json"));
  const std::string table = text_of("plan.csv");
  for (const Json& chosen : json["chosen"]) {
    std::istringstream rows(table);
    std::string row;
    while (std::getline(rows, row) && !row.starts_with(chosen["placement"].get<std::string>() + ",")) {
    }
    std::vector<double> numbers;
    std::istringstream cells(row);
    for (std::string cell; std::getline(cells, cell, ',');) {
      numbers.push_back(numbers.size() < 3 ? 0.0 : std::stod(cell));
    }
    ASSERT_EQ(numbers.size(), 3u + 6u + 6u) << row;
    const auto rotation = [&](int axis, double degrees) {
      return Eigen::AngleAxisd(degrees * 3.14159265358979323846 / 180.0, Eigen::Vector3d::Unit(axis))
          .toRotationMatrix();
    };
    const Eigen::Matrix3d turned = rotation(2, numbers[14]) * rotation(1, numbers[13]) * rotation(0, numbers[12]);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(numbers[9 + i], chosen["translation_mm"][i].get<double>(), 0.006);
      for (int j = 0; j < 3; ++j) {
        EXPECT_NEAR(turned(i, j), chosen["rotation"][i][j].get<double>(), 3e-5);
      }
    }
  }
}

TEST_F(PlanCommand, ThePictureHasNumbersOnItsAxes) {
  ASSERT_EQ(plan({"2", "--probing-noise", "3 um", "--picture", "plan.svg"}).exit_code, 0);
  const std::string picture = text_of("plan.svg");
  EXPECT_THAT(picture, AllOf(HasSubstr(">x, mm</text>"), HasSubstr(">y, mm</text>"), HasSubstr(">z, mm</text>")));
  const std::regex number("<text class=\"number\"[^>]*>(-?[0-9]+)</text>");
  EXPECT_GE(std::distance(std::sregex_iterator(picture.begin(), picture.end(), number), {}), 16);
  // Zero stands below the dot of the base's origin.
  std::smatch origin, zero;
  ASSERT_TRUE(std::regex_search(picture, origin, std::regex("<circle cx=\"([0-9.]+)\" cy=\"[0-9.]+\" r=\"4\"")));
  ASSERT_TRUE(std::regex_search(picture, zero, std::regex("<text class=\"number\" x=\"([0-9.]+)\"[^>]*>0</text>")));
  EXPECT_EQ(origin[1], zero[1]);
}

// A plan states its stand itself; a position beyond it is refused, with the plan's line.
TEST_F(PlanCommand, AStatedPositionThatTheStandDoesNotHoldIsRefused) {
  write("plan.toml",
        "schema = \"artcal-plan/1\"\narm = \"ball-bar/arm.toml\"\nartefacts = [\"ball-bar/bar.toml\"]\n"
        "units = { length = \"mm\", angle = \"deg\" }\n[stand]\nfloor = -100\n[[placement]]\nname = \"low\"\n"
        "position = [500, 0, -150]\n[[probing]]\npoints = 5\n");
  const Ended ended = run({"simulate", "plan.toml", "-o", "made"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("plan.toml:7"), HasSubstr("\"low\" is not one that the stand holds"),
                               HasSubstr("below the floor at -100.0 mm")));
}

TEST_F(PlanCommand, SaysTheSameEveryTime) {
  const auto json = [&] { return plan({"2", "--probing-noise", "3 um", "--json", "-"}).out; };
  const std::string first = json();
  EXPECT_EQ(first, json());
  EXPECT_EQ(Json::parse(first)["chosen"].size(), 2u);
}

TEST_F(PlanCommand, RefusesWhatMakesNoPlan) {
  const Ended many = plan({"9", "--probing-noise", "3 um"});
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_THAT(many.err, HasSubstr("9 placements are to be chosen, but only 8 are possible"));
  const Ended zero = plan({"2", "--probing-noise", "0 um"});
  EXPECT_EQ(zero.exit_code, 2);
  EXPECT_THAT(zero.err, HasSubstr("--probing-noise is \"0 um\", expected a number above zero"));
  const Ended bare = run({"plan", "ball-bar/arm.toml", "--encoder-noise", "2 arcsec", "--probing-noise", "3 um"});
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_THAT(bare.err, HasSubstr("--artefact artefact.toml"));
  const Ended other = plan({"2", "--probing-noise", "3 um", "--measured", "ball-bar/bar.toml"});
  EXPECT_EQ(other.exit_code, 3);
  const Ended over = plan({"2", "--probing-noise", "3 um", "-o", "ball-bar/arm.toml"});
  EXPECT_NE(over.exit_code, 0);
}

}  // namespace
}  // namespace artcal
