#include "acquisition/recording/recording_text.h"

#include <gtest/gtest.h>

#include "acquisition/recording/recording_file.h"
#include "core/units.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

/// Reads the example, writes it, and reads what was written.
class RecordingTextTest : public ::testing::Test {
 protected:
  static Recording read(const std::filesystem::path& path) {
    auto recording = read_recording(path);
    if (!recording) throw std::runtime_error(recording.error().text());
    return std::move(*recording);
  }
  Recording there_and_back(const Recording& recording) const {
    (void)folder_.write("again.csv", readings_file_text(recording));
    const RecordingFiles files{"arm.toml", {"a \"quoted\" name.toml"}, "again.csv"};
    return read(folder_.write("again.toml", recording_file_text(recording, files, {"a comment"})));
  }
  testing::TemporaryFolder folder_;
};

TEST_F(RecordingTextTest, ReadsBackAsItWas) {
  testing::ExampleRecording example;
  example.readings =
      "placement,feature,orientation,repeat,temperature,arm_temperature,length,ref_x,ref_y,ref_z,q1,q2\n"
      "\"left, upper\",A,1,2,20.25,23.5,1000.123456789,1,2,3,10,20.123456789012\n"
      "\"#2 \",\"B\"\"\",,,,,,,,,-179.5,40\n";
  Recording recording = read(example.write(folder_));
  recording.name = "a \"name\" \\ of its own";
  recording.noise = {{}, 2.0 * units::arcsecond, 0.003};
  const Recording again = there_and_back(recording);
  EXPECT_EQ(again.name, recording.name);
  EXPECT_NEAR(*again.noise.encoder, *recording.noise.encoder, 1e-18);
  EXPECT_NEAR(*again.noise.probing, 0.003, 1e-15);
  EXPECT_LT((again.joints - recording.joints).cwiseAbs().maxCoeff(), 2e-14);
  ASSERT_EQ(again.readings.size(), 2u);
  EXPECT_EQ(again.placements.name(0), "left, upper");
  EXPECT_EQ(again.placements.name(again.readings[1].placement), recording.placements.name(1));
  EXPECT_EQ(again.features.name(again.readings[1].feature), "B\"");
  EXPECT_EQ(again.orientations.name(again.readings[0].orientation), "1");
  EXPECT_EQ(again.repeats.name(again.readings[0].repeat), "2");
  EXPECT_DOUBLE_EQ(again.readings[0].temperature, 20.25);
  EXPECT_DOUBLE_EQ(again.readings[0].arm_temperature, 23.5);
  EXPECT_TRUE(std::isnan(again.readings[1].temperature));
  EXPECT_TRUE(std::isnan(again.readings[1].arm_temperature));
  EXPECT_DOUBLE_EQ(again.readings[0].length, 1000.123456789);
  EXPECT_EQ(again.readings[0].reference, Eigen::Vector3d(1.0, 2.0, 3.0));
}

TEST_F(RecordingTextTest, ScansReadBackAsTheyWere) {
  testing::ExampleRecording example;
  example.readings = "q1,q2\n1,2\n";
  Recording recording = read(example.write(folder_));
  recording.readings.clear();
  recording.joints.resize(2, 0);
  recording.scans.resize(2);
  recording.scans[0].path = "scan-1.pcd";
  recording.scans[0].placement = "a \"name\"";
  recording.scans[1] = recording.scans[0];
  recording.scans[1].path = "scan-2.pcd";
  recording.scans[1].artefact = "bar";
  recording.scans[1].probe = "stylus";
  recording.scans[1].orientation = "3";
  recording.scans[1].repeat = "2";
  recording.scans[1].temperature = 20.5;
  const Recording again = there_and_back(recording);
  EXPECT_TRUE(again.readings.empty());
  ASSERT_EQ(again.scans.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(std::filesystem::path(again.scans[i].path).filename(), recording.scans[i].path);
    EXPECT_EQ(again.scans[i].placement, recording.scans[i].placement);
    EXPECT_EQ(again.scans[i].artefact, recording.scans[i].artefact);
    EXPECT_EQ(again.scans[i].probe, recording.scans[i].probe);
    EXPECT_EQ(again.scans[i].orientation, recording.scans[i].orientation);
    EXPECT_EQ(again.scans[i].repeat, recording.scans[i].repeat);
    EXPECT_EQ(again.scans[i].temperature, recording.scans[i].temperature);
  }
}

TEST_F(RecordingTextTest, LeavesOutWhatIsNotThere) {
  testing::ExampleRecording example;
  example.readings = "q1,q2\n1,2\n";
  const Recording recording = read(example.write(folder_));
  EXPECT_EQ(readings_file_text(recording), "q1,q2\n1.000000000000,2.000000000000\n");
  EXPECT_FALSE(there_and_back(recording).noise.is_given());
}

}  // namespace
}  // namespace artcal
