#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "acquisition/arm/arm_file.h"
#include "tests/end_to_end/program.h"
#include "tests/support/example_recording.h"
#include "tests/support/forward_kinematics.h"

namespace artcal {
namespace {

using Json = nlohmann::json;
using ::testing::AllOf;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

class Evaluate : public testing::ProgramTest {};

// Rows of a readings.csv whose joint angles are in rad, by placement and feature.
std::map<std::string, std::vector<std::vector<double>>> postures(const std::string& text) {
  std::map<std::string, std::vector<std::vector<double>>> found;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string placement, feature, field;
    std::getline(fields, placement, ',');
    std::getline(fields, feature, ',');
    std::vector<double> q;
    while (std::getline(fields, field, ',')) {
      q.push_back(std::stod(field));
    }
    found[placement + "/" + feature].push_back(q);
  }
  return found;
}

struct Scatter {
  double rms = 0.0;
  std::map<std::string, Eigen::Vector3d> means;
};

// By the arm's equations alone: a seat is where its readings are on the mean.
Scatter scatter_of(const Arm& arm, const std::string& readings) {
  const testing::ArmNumbers<double> numbers(arm);
  Scatter scatter;
  double squares = 0.0;
  int count = 0;
  for (const auto& [name, rows] : postures(readings)) {
    std::vector<Eigen::Vector3d> tips;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& q : rows) {
      tips.push_back(testing::tip_in_base(numbers, q, 0));
      sum += tips.back();
    }
    scatter.means[name] = sum / static_cast<double>(tips.size());
    for (const Eigen::Vector3d& tip : tips) {
      squares += (tip - scatter.means[name]).squaredNorm();
      ++count;
    }
  }
  scatter.rms = std::sqrt(squares / count);
  return scatter;
}

// Half of the placements, under the name of `folder`.
void keep_placements(const std::string& from, const std::string& to, const std::vector<std::string>& placements) {
  std::ifstream in(from);
  std::ofstream out(to);
  std::string line;
  std::getline(in, line);
  out << line << "\n";
  while (std::getline(in, line)) {
    for (const std::string& placement : placements) {
      if (line.starts_with(placement + ",")) {
        out << line << "\n";
      }
    }
  }
}

TEST_F(Evaluate, FiguresAreThoseOfTheEquationsAlone) {
  take("two-socket-bar");
  const Ended ended = run({"evaluate", "two-socket-bar/recording.toml", "--json", "-"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Json json = Json::parse(ended.out);
  const auto arm = read_arm_file(file("two-socket-bar/arm.toml"));
  ASSERT_TRUE(arm);
  const Scatter expected = scatter_of(arm->arm, text_of("two-socket-bar/readings.csv"));
  EXPECT_NEAR(json["evaluation"]["overall"]["rms_mm"].get<double>(), expected.rms, 1e-9);
  for (const Json& length : json["evaluation"]["lengths"]) {
    const std::string placement = length["placement"];
    const double between = (expected.means.at(placement + "/0") - expected.means.at(placement + "/1")).norm();
    EXPECT_NEAR(length["error_mm"].get<double>(), between - 50.0, 1e-9) << placement;
  }
  ASSERT_EQ(json["readings"].size(), 387u);
  double squares = 0.0;
  for (const Json& reading : json["readings"]) {
    squares += std::pow(reading["deviation_mm"].get<double>(), 2);
  }
  EXPECT_NEAR(std::sqrt(squares / 387.0), expected.rms, 1e-9);
}

// A distance from a seat has no sign, a deviation from the surface of a ball has one.
TEST_F(Evaluate, OnlyDeviationsThatHaveASignAreShownWithOne) {
  take("two-socket-bar");
  take("ball-bar");
  const auto largest = [&](const std::string& recording) {
    const Ended ended = run({"evaluate", recording});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const std::size_t at = ended.out.find("Largest deviations of single readings:\n");
    return at == std::string::npos ? "" : ended.out.substr(at);
  };
  EXPECT_THAT(largest("two-socket-bar/recording.toml"), AllOf(MatchesRegex(".*: [0-9.]+ mm\n.*"), Not(HasSubstr("+"))));
  EXPECT_THAT(largest("ball-bar/recording.toml"), MatchesRegex("[^\n]*\n([^\n]*: [+-][0-9.]+ mm\n){5}"));
}

TEST_F(Evaluate, AnArmIsHeldAgainstReadingsThatItHasNotSeen) {
  take("two-socket-bar");
  const std::string all = file("two-socket-bar/readings.csv");
  std::filesystem::rename(all, file("all.csv"));
  keep_placements(file("all.csv"), all, {"backcenter", "backleft", "frontcenter", "frontright"});
  ASSERT_EQ(run({"identify", "two-socket-bar/recording.toml", "-o", "four.toml", "-q", "--no-leave-out"}).exit_code, 0);
  const Ended same = run({"evaluate", "two-socket-bar/recording.toml", "--arm", "four.toml"});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("was identified from 257 of these 257 readings"));
  keep_placements(file("all.csv"), all, {"backright", "frontleft"});
  const Ended ended = run({"evaluate", "two-socket-bar/recording.toml", "--arm", "four.toml", "--json", "r.json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, Not(HasSubstr("was identified from")));
  const auto arm = read_arm_file(file("four.toml"));
  ASSERT_TRUE(arm);
  const double expected = scatter_of(arm->arm, text_of("two-socket-bar/readings.csv")).rms;
  EXPECT_NEAR(Json::parse(text_of("r.json"))["evaluation"]["overall"]["rms_mm"].get<double>(), expected, 1e-9);
  EXPECT_LT(expected, 0.3);  // of 3.2 mm with the nominal arm
}

TEST_F(Evaluate, AnotherKindOfArmIsRefused) {
  take("two-socket-bar");
  take("ball-bar");
  const Ended joints = run({"evaluate", "two-socket-bar/recording.toml", "--arm", "ball-bar/arm.toml"});
  EXPECT_EQ(joints.exit_code, 3);
  EXPECT_THAT(joints.err, HasSubstr("has 6 joints and the recording's has 7"));
  write("renamed.toml", testing::replaced(text_of("two-socket-bar/arm.toml"), "name = \"ball\"", "name = \"stylus\""));
  const Ended probe = run({"evaluate", "two-socket-bar/recording.toml", "--arm", "renamed.toml"});
  EXPECT_EQ(probe.exit_code, 3);
  EXPECT_THAT(probe.err, HasSubstr("has no probe \"ball\""));
  EXPECT_EQ(run({"evaluate", "nothing.toml"}).exit_code, 3);
}

// Its own arm like another one: tips without the temperature would be those of an arm at its reference temperature.
TEST_F(Evaluate, AnArmThatExpandsNeedsItsTemperature) {
  take("two-socket-bar");
  write("two-socket-bar/arm.toml",
        testing::replaced(text_of("two-socket-bar/arm.toml"), "a = 82.5\n", "a = 82.5\nexpansion_per_K = 23e-6\n"));
  const Ended ended = run({"evaluate", "two-socket-bar/recording.toml"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("expected the column arm_temperature"));
}

}  // namespace
}  // namespace artcal
