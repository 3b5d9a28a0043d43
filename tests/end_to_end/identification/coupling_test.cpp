// `artcal coupling`: on a recording, and on an arm alone.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using ::testing::ContainsRegex;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::json;

class CouplingCommand : public testing::ProgramTest {};

TEST_F(CouplingCommand, TellsWhatARecordingCannot) {
  take("two-socket-bar");
  const Ended ended = run({"coupling", "two-socket-bar/recording.toml"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_THAT(ended.out, HasSubstr("rank 25 of 31: 25 combinations are identifiable, 6 are not"));
  EXPECT_THAT(ended.out, HasSubstr("lz + d7 is identifiable, d7 alone is not; d7 is fixed"));
  EXPECT_THAT(ended.out, HasSubstr("Unidentifiable directions (mm and rad):"));
  EXPECT_THAT(ended.out, HasSubstr("singular values"));
}

// Harmonics of all encoders add their number to the rank, whatever is read; a gain as well.
TEST_F(CouplingCommand, AnswersForRicherModels) {
  take("gao2013");
  for (const auto& [kind, rank] : {std::pair{"base", 23}, {"distance", 21}, {"point", 20}}) {
    const Ended told =
        run({"coupling", "gao2013/table1.toml", "--kind", kind, "--model", "dh+eccentricity+eccentricity2+gain"});
    EXPECT_EQ(told.exit_code, 0) << told.err;
    EXPECT_THAT(told.out, HasSubstr("rank " + std::to_string(rank + 30) + " of 55")) << kind;
  }
  const Ended tip = run({"coupling", "gao2013/table1.toml", "--kind", "base", "--model", "dh+tip"});
  EXPECT_THAT(tip.out, HasSubstr("lx alone is not; lx is fixed"));
  EXPECT_EQ(run({"coupling", "gao2013/table1.toml", "--kind", "base", "--model", "dh+gravity"}).exit_code, 2);
  EXPECT_EQ(run({"coupling", "gao2013/table1.toml", "--kind", "base", "--model", "auto"}).exit_code, 2);
  EXPECT_THAT(run({"coupling", "gao2013/table1.toml", "--kind", "base", "--model", "dh+gains"}).err,
              HasSubstr("\"gains\", expected"));
}

// Ranks of Table 1's arm: 25 parameters; what each kind of reading cannot see of them.
TEST_F(CouplingCommand, KnowsEveryKindOfReading) {
  take("gao2013");
  const std::vector<std::tuple<std::string, int, std::string>> kinds{
      {"base", 23, "scale: identifiable"},
      {"frame", 21, "scale: identifiable"},
      {"point", 20, "scale: not identifiable"},
      {"distance", 21, "scale: identifiable"},
      {"sphere", 21, "scale: weakly identifiable"},
      {"length", 21, "scale: identifiable"},
      {"plate", 21, "scale: identifiable"},
      {"plane", 20, "scale: not identifiable"},
      {"sphere-unknown-radius", 20, "scale: not identifiable"},
      {"plane-perpendicular", 18, "scale: not identifiable"}};
  for (const auto& [kind, rank, scale] : kinds) {
    const std::vector<std::string> command{"coupling", "gao2013/table1.toml", "--kind", kind};
    const Ended told = run(command);
    EXPECT_EQ(told.exit_code, 0) << told.err;
    EXPECT_THAT(told.out, HasSubstr("240 readings at random postures"));
    EXPECT_THAT(told.out, HasSubstr("rank " + std::to_string(rank) + " of 25")) << kind;
    EXPECT_THAT(told.out, HasSubstr(scale)) << kind;
    std::vector<std::string> as_json = command;
    as_json.insert(as_json.end(), {"--json", "-", "--seed", "7", "--readings", "300", "--features", "6"});
    const Ended first = run(as_json);
    const Json json = Json::parse(first.out);
    EXPECT_EQ(json["coupling"]["rank"], rank) << kind;
    EXPECT_EQ(json["seed"], 7);
    EXPECT_EQ(json["made_up"]["kind"], kind);
    EXPECT_EQ(json["made_up"]["readings"], 300);
    EXPECT_EQ(json["made_up"]["features"], 6);
    EXPECT_EQ(first.out, run(as_json).out) << "the same bytes, there are no timings";
  }
}

TEST_F(CouplingCommand, PassesWarningsOnFromTheArtefacts) {
  take("two-socket-bar");
  std::string readings = text_of("two-socket-bar/readings.csv");
  std::string warm = "temperature,";
  for (std::size_t at = 0; at < readings.size();) {
    const std::size_t end = std::min(readings.find('\n', at), readings.size());
    warm += (at == 0 ? "" : "25,") + readings.substr(at, end - at) + "\n";
    at = end + 1;
  }
  write("two-socket-bar/readings.csv", warm);
  const Ended ended = run({"coupling", "two-socket-bar/recording.toml", "--json", "r.json"});
  EXPECT_THAT(ended.out, HasSubstr("Warning: the artefact \"two-socket bar\" was used 5.0 K away from 20 degC"));
  EXPECT_THAT(Json::parse(text_of("r.json"))["warnings"][0].get<std::string>(), HasSubstr("expansion_per_K"));
}

TEST_F(CouplingCommand, WrongUsageIsTwo) {
  take("gao2013");
  take("two-socket-bar");
  const std::string arm = "gao2013/table1.toml";
  const std::string recording = "two-socket-bar/recording.toml";
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"coupling", arm},
                                             {"coupling", recording, "--kind", "base"},
                                             {"coupling", arm, "--kind", "laser"},
                                             {"coupling", arm, "--readings", "10"},
                                             {"coupling", arm, "--kind", "base", "--readings", "0"},
                                             {"coupling", arm, "--kind", "base", "--hold", "a77"},
                                             {"coupling", recording, "--angle-scale", "-1"},
                                             {"coupling", recording, "--json", recording},
                                             {"coupling"}}) {
    const Ended ended = run(wrong);
    EXPECT_EQ(ended.exit_code, 2) << wrong.back();
    EXPECT_THAT(ended.out, IsEmpty());
  }
  EXPECT_THAT(run({"coupling", arm}).err, HasSubstr("--kind base"));
}

TEST_F(CouplingCommand, BadInputIsThree) {
  take("two-socket-bar");
  EXPECT_EQ(run({"coupling", "none.toml"}).exit_code, 3);
  EXPECT_EQ(run({"coupling", "two-socket-bar/bar.toml"}).exit_code, 3);
  EXPECT_EQ(run({"coupling", "two-socket-bar/readings.csv"}).exit_code, 3);
}

TEST_F(CouplingCommand, WhatAnArmCannotReadIsFour) {
  write("hinge.toml",
        "schema = \"artcal-arm/1\"\nconvention = \"standard\"\nunits = { length = \"mm\", angle = \"deg\" }\n"
        "[[joint]]\na = 100\nd = 0\ntheta = 0\nalpha = 0\n[[probe]]\nl = 50\n");
  for (const char* kind : {"sphere", "distance"}) {
    const Ended ended = run({"coupling", "hinge.toml", "--kind", kind});
    EXPECT_EQ(ended.exit_code, 4) << kind;
    EXPECT_THAT(ended.err, ContainsRegex("only [0-9]+ of 240 readings of this kind can be made up"));
  }
  EXPECT_EQ(run({"coupling", "hinge.toml", "--kind", "distance", "--readings", "1"}).exit_code, 4);
}

}  // namespace
}  // namespace artcal
