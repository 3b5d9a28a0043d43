#include "acquisition/recording/readings_file.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/hash.h"
#include "core/units.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

class ReadingsFile : public ::testing::Test {
 protected:
  ReadingsFile() {
    recording.arm.name = "two";
    recording.arm.joints.resize(2);
    recording.arm.probes.resize(1);
    recording.arm.probes[0].name = "ball";
  }

  Expected<void> read(std::string_view text, ReadingUnits units = {units::degree, 1.0}) {
    return read_readings(folder_.write("r.csv", text), units, recording);
  }
  // The message without the folder.
  std::string refusal(std::string_view text) {
    const auto result = read(text);
    return result ? "accepted" : result.error().text().substr(folder_.path().string().size() + 1);
  }

  Recording recording;
  testing::TemporaryFolder folder_;
};

// `count` readings, the header aside; line `bad` (from 1, the header is line 1) has "oops" for q2.
std::string many_lines(int count, int bad) {
  std::string text = "artefact,placement,feature,q1,q2\n";
  for (int line = 2; line <= count + 1; ++line) {
    text += fmt::format("bar,p{},A,{}.5,{}\n", line % 7, line % 180, line == bad ? "oops" : std::to_string(-line % 90));
  }
  return text;
}

TEST_F(ReadingsFile, ReadsEverything) {
  ASSERT_TRUE(
      read("artefact,placement,feature,orientation,repeat,probe,temperature,arm_temperature,length,ref_x,ref_y,"
           "ref_z,q2,q1,x-note\n"
           "bar,p1,A,up,1,ball,20.5,23.25,0.5,1,2,3,90,-45,hello\n"
           "bar,p2,B,down,2,,,,,,,,180,30,\n",
           {units::degree, units::metre}));
  ASSERT_EQ(recording.readings.size(), 2u);
  ASSERT_EQ(recording.joints.rows(), 2);
  ASSERT_EQ(recording.joints.cols(), 2);
  EXPECT_DOUBLE_EQ(recording.joints(0, 0), -M_PI / 4);
  EXPECT_DOUBLE_EQ(recording.joints(1, 0), M_PI / 2);
  EXPECT_DOUBLE_EQ(recording.joints(1, 1), M_PI);
  const Reading& first = recording.readings[0];
  EXPECT_EQ(recording.artefacts.name(first.artefact), "bar");
  EXPECT_EQ(recording.placements.name(first.placement), "p1");
  EXPECT_EQ(recording.features.name(first.feature), "A");
  EXPECT_EQ(recording.orientations.name(first.orientation), "up");
  EXPECT_EQ(recording.repeats.name(first.repeat), "1");
  EXPECT_EQ(first.temperature, 20.5);
  EXPECT_EQ(first.arm_temperature, 23.25);
  EXPECT_EQ(first.length, 500.0);
  EXPECT_EQ(first.reference, Eigen::Vector3d(1000.0, 2000.0, 3000.0));
  EXPECT_EQ(first.line, 2);
  const Reading& second = recording.readings[1];
  EXPECT_EQ(recording.placements.name(second.placement), "p2");
  EXPECT_TRUE(std::isnan(second.temperature));
  EXPECT_TRUE(std::isnan(second.arm_temperature));
  EXPECT_TRUE(std::isnan(second.length));
  EXPECT_TRUE(second.reference.array().isNaN().all());
  EXPECT_EQ(second.probe, 0);
}

TEST_F(ReadingsFile, SeveralFilesFollowOneAnother) {
  ASSERT_TRUE(read("placement,feature,q1,q2\np1,A,1,2\n"));
  ASSERT_TRUE(read_readings(folder_.write("s.csv", "feature,placement,q2,q1\nA,p2,4,3\nB,p1,6,5\n"), {}, recording));
  ASSERT_EQ(recording.readings.size(), 3u);
  EXPECT_EQ(recording.readings[1].file, 1);
  EXPECT_EQ(recording.placements.name(recording.readings[1].placement), "p2");
  EXPECT_EQ(recording.readings[2].placement, recording.readings[0].placement);
  EXPECT_EQ(recording.joints.col(2), Eigen::Vector2d(5.0, 6.0));
  EXPECT_THAT(recording.where(2), EndsWith("s.csv:3"));
  ASSERT_EQ(recording.inputs.size(), 2u);
  EXPECT_EQ(recording.inputs[0].sha256, sha256("placement,feature,q1,q2\np1,A,1,2\n"));
}

TEST_F(ReadingsFile, OneBadFieldAmongAThousandLinesIsNamed) {
  EXPECT_EQ(refusal(many_lines(1000, 700)), "r.csv:700:16: column q2: found \"oops\", expected an angle in deg");
}

TEST_F(ReadingsFile, NanInfinityAndEmptyAnglesAreRefused) {
  for (const std::string bad : {"nan", "NaN", "inf", "-Infinity", "1e999"}) {
    EXPECT_EQ(refusal("q1,q2\n1," + bad + "\n"),
              "r.csv:2:3: column q2: found \"" + bad + "\", expected an angle in deg");
  }
  EXPECT_EQ(refusal("q1,q2\n,2\n"), "r.csv:2:1: column q1: found nothing, expected an angle in deg");
}

TEST_F(ReadingsFile, OptionalNumbersAreCheckedToo) {
  EXPECT_THAT(refusal("q1,q2,temperature\n1,2,warm\n"),
              HasSubstr("column temperature: found \"warm\", expected a temp"));
  EXPECT_THAT(refusal("q1,q2,length\n1,2,inf\n"), HasSubstr("column length: found \"inf\", expected a length"));
  EXPECT_THAT(refusal("q1,q2,ref_x,ref_y,ref_z\n1,2,0,0,z\n"),
              HasSubstr("column ref_z: found \"z\", expected a coord"));
}

TEST_F(ReadingsFile, WrongNumberOfJointsIsSaid) {
  EXPECT_EQ(refusal("q1\n1\n"), "r.csv:1:1: the column q2 is missing; the arm \"two\" has 2 joints, expected q1 … q2");
  EXPECT_EQ(refusal("q1,q2,q3\n1,2,3\n"),
            "r.csv:1:7: there is a column q3, but the arm \"two\" has 2 joints; is it the right arm?");
}

TEST_F(ReadingsFile, UnknownAndDoubledColumnsAreRefused) {
  EXPECT_THAT(refusal("q1,q2,placment\n1,2,p\n"), HasSubstr("r.csv:1:7: the column \"placment\" is not known"));
  EXPECT_THAT(refusal("q1,q2,q1\n1,2,3\n"), HasSubstr("r.csv:1:7: the column \"q1\" is there twice"));
  for (const std::string odd : {"q0", "q-1", "q01", "q+1", "q", "qa", "Q1", "q1x", "q99999999999999999999"}) {
    EXPECT_THAT(refusal("q1,q2," + odd + "\n1,2,3\n"), HasSubstr("the column \"" + odd + "\" is not known")) << odd;
  }
}

TEST_F(ReadingsFile, ReferencesNeedAllThreeCoordinates) {
  EXPECT_THAT(refusal("q1,q2,ref_x,ref_z\n1,2,3,4\n"), HasSubstr("all three of ref_x, ref_y, ref_z"));
}

TEST_F(ReadingsFile, UnknownProbesAreRefused) {
  EXPECT_EQ(refusal("probe,q1,q2\nball,1,2\nstar,1,2\n"),
            "r.csv:3:1: the reading names the probe \"star\", expected one of: ball");
  recording.arm.probes.push_back({"star", Eigen::Vector3d::Zero(), 0.0, false});
  EXPECT_EQ(refusal("q1,q2\n1,2\n"), "r.csv:2:1: the reading names no probe, and the arm has several: ball, star");
  recording.readings.clear();
  recording.joints.resize(0, 0);
  ASSERT_TRUE(read("probe,q1,q2\nstar,1,2\nball,1,2\n"));
  EXPECT_EQ(recording.readings[0].probe, 1);
  EXPECT_EQ(recording.readings[1].probe, 0);
}

TEST_F(ReadingsFile, EmptyMissingAndHeaderOnlyFilesAreRefused) {
  EXPECT_EQ(refusal(""), "r.csv: the file is empty");
  EXPECT_EQ(refusal("\n\n"),
            "r.csv: the file has no header line, expected column names such as placement,feature,q1,q2");
  EXPECT_EQ(refusal("q1,q2\n"), "r.csv: the file has a header but no readings");
  EXPECT_THAT(read_readings(folder_.path() / "none.csv", {}, recording).error().text(),
              HasSubstr("none.csv: there is no such file"));
  EXPECT_THAT(read_readings(folder_.path(), {}, recording).error().text(), HasSubstr("folder"));
}

TEST_F(ReadingsFile, WindowsLineEndsAndTheByteOrderMarkSimplyWork) {
  const std::string text = many_lines(20, 0);
  ASSERT_TRUE(read(text));
  const Recording plain = recording;
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : text) {
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  recording.readings.clear();
  recording.joints.resize(0, 0);
  ASSERT_TRUE(read(windows));
  EXPECT_EQ(recording.joints, plain.joints);
  EXPECT_EQ(recording.placements.size(), plain.placements.size());
  for (std::size_t i = 0; i < plain.readings.size(); ++i) {
    EXPECT_EQ(recording.readings[i].placement, plain.readings[i].placement);
    EXPECT_EQ(recording.readings[i].line, plain.readings[i].line);
  }
}

TEST_F(ReadingsFile, QuotedLabelsKeepTheirCommas) {
  ASSERT_TRUE(read("placement,feature,q1,q2\n\"left, low\",\"the \"\"A\"\"\",1,2\n"));
  EXPECT_EQ(recording.placements.name(0), "left, low");
  EXPECT_EQ(recording.features.name(0), "the \"A\"");
}

TEST_F(ReadingsFile, OtherSeparatorsAndRaggedRowsAreRefused) {
  EXPECT_THAT(refusal("q1;q2\n1,5;2,5\n"), HasSubstr("semicolons"));
  EXPECT_EQ(refusal("q1,q2\n1,2\n1\n"), "r.csv:3:1: the line has 1 fields, expected 2 as in the header");
  EXPECT_EQ(refusal("q1,q2\n1,5,2,5\n"),
            "r.csv:2:1: the line has 4 fields, expected 2 as in the header; are there decimal commas? Numbers have "
            "points here");
}

TEST_F(ReadingsFile, HostileInputIsRefusedBriefly) {
  EXPECT_THAT(refusal(std::string_view("q1,q2\n1,\0\n", 10)), HasSubstr("zero bytes"));
  EXPECT_THAT(refusal("\x7f"
                      "ELF\x02\x01\x01\n"),
              HasSubstr("control character"));
  EXPECT_THAT(refusal("q1,q2\n1,\x1b[31m2\n"), HasSubstr("control character"));
  EXPECT_THAT(refusal("q1,q2\n1,2\xff\n"), HasSubstr("not UTF-8"));
  const std::string long_text(5'000'000, '7');
  EXPECT_LT(refusal("q1,q2\n1," + long_text + "\n").size(), 150u);
  EXPECT_LT(refusal("q1,q2," + long_text + "\n1,2,3\n").size(), 350u);
  EXPECT_LT(refusal("q1,q2,probe\n1,2," + long_text + "\n").size(), 150u);
}

class SuspiciousAngles : public ReadingsFile {
 protected:
  std::vector<std::string> warnings(std::string_view text, double unit) {
    EXPECT_TRUE(read(text, {unit, 1.0}));
    return suspicious_angles(recording, unit);
  }
};

constexpr std::string_view small = "q1,q2\n0.1,-3.1\n1.2,0.3\n-1,1\n2,2\n0,3\n";
constexpr std::string_view large = "q1,q2\n10,-170\n45,90\n-1,1\n2,2\n0,3\n";

TEST_F(SuspiciousAngles, RadiansCalledDegrees) {
  EXPECT_THAT(warnings(small, units::degree), ElementsAre(HasSubstr("look like radians")));
}
TEST_F(SuspiciousAngles, DegreesCalledRadians) {
  EXPECT_THAT(warnings(large, units::radian), ElementsAre(HasSubstr("look like degrees")));
}
TEST_F(SuspiciousAngles, NoneWhereTheUnitFits) {
  EXPECT_THAT(warnings(small, units::radian), ::testing::IsEmpty());
  recording.readings.clear();
  recording.joints.resize(0, 0);
  EXPECT_THAT(warnings(large, units::degree), ::testing::IsEmpty());
}

}  // namespace
}  // namespace artcal
