#include "acquisition/csv/cut_off.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/recording/recording_file.h"
#include "tests/support/cloud_file.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using testing::CloudFile;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A table with one column, whose last field the text's end leaves open: "refused", "warned" or "taken".
std::string fate(const std::vector<std::string>& above, const std::string& last) {
  CutOffWatch watch("no line end");
  for (const std::string& field : above) {
    watch.row(field, false);
  }
  watch.row(last, true);
  const auto judged = watch.judge("t.csv:9");
  return !judged ? "refused" : judged->empty() ? "taken" : "warned";
}

TEST(CutOff, ANumberWithFewerDigitsThanItsColumnIsRefused) {
  EXPECT_EQ(fate({"12.345678", "-7.000001"}, "12.3456"), "refused");
  EXPECT_EQ(fate({"12.345678", "-7.000001"}, "12."), "refused");
  EXPECT_EQ(fate({"12.345678", "-7.000001"}, "12"), "refused");
  EXPECT_EQ(fate({"12.345678", "-7.000001"}, ""), "refused");
  EXPECT_EQ(fate({"1.5e-05", "2.5e-05"}, "3.5e-0"), "refused");
  EXPECT_EQ(fate({"1.5e-05", "2.5e-05"}, "3.5"), "refused");
  EXPECT_EQ(fate({"1024", "9999"}, "102"), "refused");
  EXPECT_EQ(fate({"nan", "0.125", "0.250"}, "0.1"), "refused");
}

TEST(CutOff, ANumberThatMayBeWholeIsAWarning) {
  EXPECT_EQ(fate({"12.345678", "-7.000001"}, "112.345678"), "warned");
  EXPECT_EQ(fate({"12.3", "-7.000001"}, "12.3"), "warned");
  EXPECT_EQ(fate({"left", "right"}, "le"), "warned");
  EXPECT_EQ(fate({"", ""}, ""), "warned");
  EXPECT_EQ(fate({}, "12"), "warned");
}

TEST(CutOff, ALineEndSaysThatTheNumberIsWhole) {
  for (const char* text : {"12.345\n12.3\n", "12.345\r\n12.3\r"}) {
    CutOffWatch watch(text);
    watch.row("12.345", false);
    watch.row("12.3", false);
    EXPECT_THAT(watch.judge("t.csv:2").value(), IsEmpty());
  }
}

class CutOffCloud : public CloudFile {};

TEST_F(CutOffCloud, TextPcdAndPlyThatLostTheirEndAreRefused) {
  const std::string pcd =
      "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  const std::string blanks = "1.000 2.000 3.125\n4.000 5.000 6.250\n7.000 8.000 9.375";
  const std::string commas = "x,y,z\n1.000,2.000,3.125\n4.000,5.000,6.250\n7.000,8.000,9.375";
  for (const auto& [name, whole] : {std::pair("p.xyz", blanks), std::pair("p.csv", commas),
                                    std::pair("p.pcd", pcd + blanks), std::pair("p.ply", ply + blanks)}) {
    for (const std::size_t lost : {1, 2, 3}) {
      EXPECT_THAT(refusal(name, whole.substr(0, whole.size() - lost)), HasSubstr("probably cut off")) << name << lost;
    }
    const auto warned = read(name, whole);
    ASSERT_TRUE(warned) << name;
    EXPECT_THAT(warned->warnings, ElementsAre(HasSubstr("no line end"))) << name;
    const auto clean = read(name, whole + "\n");
    ASSERT_TRUE(clean) << name;
    EXPECT_THAT(clean->warnings, IsEmpty()) << name;
  }
}

TEST(CutOffReadings, StandInTheRecordingsWarningsOrAreRefused) {
  testing::TemporaryFolder folder;
  testing::ExampleRecording example;
  example.readings = "placement,feature,q1,q2\np1,A,10,20.25\np1,B,30,40.50\np2,A,-50,60.75\np2,B,70,-80.00";
  auto recording = read_recording(example.write(folder));
  ASSERT_TRUE(recording) << recording.error().text();
  EXPECT_THAT(recording->warnings, ElementsAre(HasSubstr("readings.csv:5: the last line has no line end")));
  example.readings.resize(example.readings.size() - 1);
  recording = read_recording(example.write(folder));
  ASSERT_FALSE(recording);
  EXPECT_THAT(recording.error().text(), HasSubstr("readings.csv:5: the last line has no line end, and -80.0 "));
  example.readings += "0\n# that was all";
  recording = read_recording(example.write(folder));
  ASSERT_TRUE(recording);
  EXPECT_THAT(recording->warnings, IsEmpty());
}

}  // namespace
}  // namespace artcal
