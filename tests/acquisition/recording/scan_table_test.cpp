// The keys of a [[scan]] in recording.toml.
#include "acquisition/recording/recording_file.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using testing::replaced;

const std::string whole =
    "[[scan]]\nfile = \"left.pcd\"\nplacement = \"left\"\nartefact = \"bar\"\nprobe = \"ball\"\ntemperature = 20.3\n"
    "orientation = \"down\"\nrepeat = \"2\"\n"
    "units = { length = \"m\", joint = \"rad\" }\ntolerance = \"0.5 mm\"\nuse_every = 7\n"
    "[[scan.place]]\nsphere = \"A\"\nat = [0.1, 0.2, -0.3]\n";

class ScanTable : public ::testing::Test {
 protected:
  Expected<Recording> read(const std::string& scan) {
    testing::ExampleRecording files;
    files.recording += scan;
    return read_recording(files.write(folder_));
  }
  std::string refusal(const std::string& scan) {
    const auto recording = read(scan);
    return recording ? "accepted" : recording.error().text();
  }
  std::string refusal(std::string_view from, std::string_view to) { return refusal(replaced(whole, from, to)); }
  testing::TemporaryFolder folder_;
};

TEST_F(ScanTable, EveryKeyArrives) {
  const auto recording = read(whole);
  ASSERT_TRUE(recording) << recording.error().text();
  ASSERT_EQ(recording->scans.size(), 1u);
  const RecordedScan& scan = recording->scans.front();
  EXPECT_EQ(scan.path, (folder_.path() / "left.pcd").string());
  EXPECT_EQ(scan.placement, "left");
  EXPECT_EQ(scan.artefact, "bar");
  EXPECT_EQ(scan.probe, "ball");
  EXPECT_EQ(scan.orientation, "down");
  EXPECT_EQ(scan.repeat, "2");
  EXPECT_EQ(scan.temperature, 20.3);
  EXPECT_EQ(scan.units.length, 1000.0);
  EXPECT_EQ(scan.units.angle, 1.0);
  EXPECT_EQ(scan.tolerance, 0.5);
  EXPECT_EQ(scan.use_every, 7);
  ASSERT_EQ(scan.places.size(), 1u);
  EXPECT_EQ(scan.places.front().sphere, "A");
  // In the file's own unit, metres.
  EXPECT_TRUE(scan.places.front().at_in_base.isApprox(Eigen::Vector3d(100.0, 200.0, -300.0), 1e-14));
  EXPECT_THAT(scan.where, HasSubstr("recording.toml:6"));
}

TEST_F(ScanTable, TheRestIsTheRecordings) {
  const auto recording = read("[[scan]]\nfile = \"left.pcd\"\nplacement = \"left\"\n");
  ASSERT_TRUE(recording) << recording.error().text();
  const RecordedScan& scan = recording->scans.front();
  EXPECT_EQ(scan.artefact + scan.probe + scan.orientation + scan.repeat, "");
  EXPECT_FALSE(scan.temperature);
  EXPECT_FALSE(scan.tolerance);
  EXPECT_EQ(scan.units.length, 1.0);
  EXPECT_EQ(scan.units.angle, std::numbers::pi / 180.0);
  EXPECT_EQ(scan.use_every, 1);
}

TEST_F(ScanTable, WhatMakesNoSenseIsRefusedByName) {
  EXPECT_THAT(refusal("length = \"m\"", "length = \"ell\""), HasSubstr("ell"));
  EXPECT_THAT(refusal("joint = \"rad\"", "joint = \"mm\""), HasSubstr("mm"));
  EXPECT_THAT(refusal("\"0.5 mm\"", "\"0.5\""), HasSubstr("the tolerance is \"0.5\", expected a length above zero"));
  EXPECT_THAT(refusal("\"0.5 mm\"", "\"-1 mm\""), HasSubstr("the tolerance is \"-1 mm\""));
  EXPECT_THAT(refusal("\"0.5 mm\"", "\"1 deg\""), HasSubstr("the tolerance is \"1 deg\""));
  EXPECT_THAT(refusal("20.3", "-400"), HasSubstr("the temperature is -400, expected degC"));
  EXPECT_THAT(refusal("20.3", "nan"), HasSubstr("temperature"));
  for (const char* number : {"0", "-3", "1.5", "1e9", "nan"}) {
    EXPECT_THAT(refusal("use_every = 7", std::string("use_every = ") + number), HasSubstr("use_every")) << number;
  }
  EXPECT_THAT(refusal("[0.1, 0.2, -0.3]", "[0.1, 0.2]"), HasSubstr("`at` has 2 numbers, expected three"));
  EXPECT_THAT(refusal("[0.1, 0.2, -0.3]", "[0.1, 0.2, \"x\"]"), HasSubstr("at"));
  EXPECT_THAT(refusal("placement = \"left\"\n", ""), HasSubstr("placement"));
  EXPECT_THAT(refusal("file = \"left.pcd\"\n", ""), HasSubstr("file"));
  EXPECT_THAT(refusal("use_every", "use_evry"), HasSubstr("use_evry"));
}

}  // namespace
}  // namespace artcal
