#include "acquisition/recording/tip_centres.h"

#include <gmock/gmock.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/recording/recording_file.h"
#include "tests/support/example_recording.h"
#include "tests/support/forward_kinematics.h"

namespace artcal {
namespace {

using testing::ExampleRecording;
using ::testing::HasSubstr;
using testing::replaced;

class TipCentresTest : public ::testing::Test {
 protected:
  Expected<Recording> read(const ExampleRecording& files) { return read_recording(files.write(folder_)); }
  testing::TemporaryFolder folder_;
};

TEST_F(TipCentresTest, AreTheArms) {
  const Recording recording = read({}).value();
  const TipCentres tips = tip_centres(recording).value();
  EXPECT_EQ(tips.source, TipSource::Joints);
  const testing::ArmNumbers<double> numbers(recording.arm);
  for (Eigen::Index i = 0; i < recording.joints.cols(); ++i) {
    const auto q = recording.joints.col(i);
    EXPECT_NEAR((tips.in_base.col(i) - testing::tip_in_base(numbers, {q.begin(), q.end()}, 0)).norm(), 0.0, 1e-10);
  }
}

TEST_F(TipCentresTest, AreReportedWhereTheFileSays) {
  ExampleRecording files;
  files.readings = "placement,feature,x,y,z,q1,q2\np1,A,1,2,3,10,20\n";
  files.recording = replaced(files.recording, "length = \"mm\"", "length = \"m\"");
  const Recording recording = read(files).value();
  const TipCentres tips = tip_centres(recording).value();
  EXPECT_EQ(tips.source, TipSource::Reported);
  EXPECT_EQ(tips.in_base.col(0), Eigen::Vector3d(1000.0, 2000.0, 3000.0));
  // An arm that is named is asked, whatever its software said.
  EXPECT_EQ(tip_centres(recording, recording.arm).value().source, TipSource::Joints);
}

TEST_F(TipCentresTest, CoordinatesNeedNoJointsAndNoArm) {
  ExampleRecording files;
  files.readings = "placement,feature,x,y,z\np1,A,1,2,3\n";
  EXPECT_TRUE(tip_centres(read(files).value()));
  EXPECT_THAT(require_joints(read(files).value()).error().text(),
              HasSubstr("readings.csv:2: the reading has coordinates"));
  files.recording = replaced(replaced(files.recording, "arm = \"arm.toml\"\n", ""), "joint = \"deg\", ", "") +
                    "[[probe]]\nradius = 3\n";
  const Recording recording = read(files).value();
  EXPECT_EQ(recording.arm.probes[0].radius, 3.0);
  EXPECT_EQ(tip_centres(recording).value().in_base.col(0), Eigen::Vector3d(1.0, 2.0, 3.0));
}

TEST_F(TipCentresTest, HalfCoordinatesAreRefused) {
  const auto refusal = [&](const std::string& readings) {
    ExampleRecording files;
    files.readings = readings;
    const auto result = read(files);
    return result ? "accepted" : result.error().text();
  };
  EXPECT_THAT(refusal("placement,x,y\np1,1,2\n"), HasSubstr("need all three of x, y, z"));
  EXPECT_THAT(refusal("placement,x,y,z\np1,1,,3\n"), HasSubstr("readings.csv:2:6: column y"));
  EXPECT_THAT(refusal("placement,x,y,z,q1\np1,1,2,3,4\n"), HasSubstr("the column q2 is missing"));
}

TEST_F(TipCentresTest, AnotherArmMustFit) {
  const Recording recording = read({}).value();
  Arm other = recording.arm;
  other.joints.pop_back();
  EXPECT_THAT(tip_centres(recording, other).error().message, HasSubstr("has 1 joints and the recording's has 2"));
  other = recording.arm;
  other.probes[0].radius = 2.0;
  EXPECT_THAT(tip_centres(recording, other).error().message, HasSubstr("one of them is wrong"));
  other.probes[0].name = "star";
  EXPECT_THAT(tip_centres(recording, other).error().message, HasSubstr("has no probe \"ball\""));
}

// The radius that was identified is the arm's; the recording's is nominal.
TEST_F(TipCentresTest, AnIdentifiedRadiusIsTaken) {
  const Recording recording = read({}).value();
  Arm other = recording.arm;
  other.probes[0].radius = 2.9987;
  ArmIdentification known;
  known.parameters = {"theta1", "radius"};
  EXPECT_TRUE(tip_centres(recording, other, &known));
  EXPECT_EQ(tip_radius(recording, 0, other), 2.9987);
  EXPECT_EQ(tip_radius(recording, 0, recording.arm), 3.0);
  known.parameters = {"theta1"};
  EXPECT_THAT(tip_centres(recording, other, &known).error().message, HasSubstr("one of them is wrong"));
}

// Of two probes the one whose radius was identified is meant, in whatever order the arm has them.
TEST_F(TipCentresTest, AnIdentifiedRadiusIsThatOfItsProbe) {
  ExampleRecording files;
  files.arm += "[[probe]]\nname = \"star\"\nl = 60\nradius = 1\n";
  files.readings = "placement,feature,probe,q1,q2\np1,A,star,10,20\n";
  const Recording recording = read(files).value();
  Arm other = recording.arm;
  std::swap(other.probes[0], other.probes[1]);
  other.probes[0].radius = 1.002;
  ArmIdentification known;
  known.parameters = {"radius:star"};
  EXPECT_TRUE(tip_centres(recording, other, &known));
  EXPECT_EQ(tip_radius(recording, 0, other), 1.002);
  known.parameters = {"radius:ball"};
  EXPECT_FALSE(tip_centres(recording, other, &known));
}

TEST_F(TipCentresTest, AnArmThatExpandsNeedsItsTemperature) {
  ExampleRecording files;
  files.arm = replaced(files.arm, "alpha = 0\n", "alpha = 0\nexpansion_ppm_per_K = 20\ngain_ppm = 100\n");
  EXPECT_THAT(tip_centres(read(files).value()).error().text(), HasSubstr("readings.csv:2: the arm's lengths depend"));
  files.readings = "placement,temperature,arm_temperature,q1,q2\np1,20,25,10,380\n";
  const Recording recording = read(files).value();
  const Eigen::VectorXd q = recording.joints.col(0);
  const auto expected = testing::tip_with_errors(testing::ArmNumbers<double>(recording.arm),
                                                 std::vector<double>(q.begin(), q.end()), 0, 5.0);
  const Eigen::Vector3d tip = tip_centres(recording).value().in_base.col(0);
  EXPECT_LT((tip - expected).norm(), 1e-10);
  // 300 mm of 20 ppm/K at 5 K.
  Arm cold = recording.arm;
  cold.reference_temperature = 25.0;
  EXPECT_NEAR((tip - tip_centres(recording, cold).value().in_base.col(0)).norm(), 0.030, 0.006);
}

TEST_F(TipCentresTest, JointLimitsSurviveTheFile) {
  ExampleRecording files;
  files.arm = replaced(files.arm, "alpha = 90\n", "alpha = 90\nmin = -170\nmax = 165\n");
  const Arm arm = read(files).value().arm;
  const auto again = read_arm_file(folder_.write("again.toml", arm_file_text(arm, {})));
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->arm.joints[0].lowest, arm.joints[0].lowest);
  EXPECT_EQ(again->arm.joints[0].highest, arm.joints[0].highest);
  EXPECT_NEAR(*arm.joints[0].highest, 165.0 * 3.14159265358979 / 180.0, 1e-12);
  EXPECT_FALSE(again->arm.joints[1].lowest);
  files.arm = replaced(files.arm, "min = -170", "min = 170");
  EXPECT_THAT(read(files).error().text(), HasSubstr("`min` of a joint is not below its `max`"));
}

}  // namespace
}  // namespace artcal
