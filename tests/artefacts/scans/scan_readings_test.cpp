#include "artefacts/scans/scan_readings.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/recording/recording_file.h"
#include "artefacts/constraints/bound_recording.h"
#include "core/files/hash.h"
#include "tests/support/arm_scans.h"
#include "tests/support/example_recording.h"
#include "tests/support/forward_kinematics.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using testing::replaced;
using ::testing::SizeIs;

constexpr double degree = std::numbers::pi / 180.0;

/// The arm of the recording is nominal, the scan is the true arm's.
class ScanReadings : public ::testing::Test {
 protected:
  void scan(std::uint64_t seed, double times = 1.0) {
    settings_.seed = seed;
    scan_ = testing::scan_with_arm(testing::planted_errors(testing::arm_with_ball_tip(), seed, times), settings_);
    text_ = testing::text_of(scan_);
  }
  Expected<Constraints> read(const ScanSelection& selection = {}) {
    source_.path = folder_.write("scan.txt", text_).string();
    source_.placement = "left";
    source_.where = "recording.toml:5";
    source_.units = {1.0, degree};
    recording_ = {};
    recording_.arm = arm_;
    recording_.scans = {source_};
    recording_.artefact_paths = {folder_.write("bar.toml", testing::bar_file(settings_)).string()};
    return bind_recording(recording_, selection).map([&](BoundRecording&& bound) {
      recording_ = std::move(bound.recording);
      return std::move(bound.constraints);
    });
  }
  std::string refusal() {
    const auto constraints = read();
    return constraints ? "accepted" : constraints.error().text();
  }
  int count_of(int ball) const { return static_cast<int>(std::count(scan_.labels.begin(), scan_.labels.end(), ball)); }

  Eigen::Vector3d nominal_tip(std::size_t row) const {
    return testing::tip_in_base(testing::ArmNumbers<double>(arm_),
                                std::vector<double>(scan_.joints[row].begin(), scan_.joints[row].end()), 0);
  }

  Arm arm_ = testing::arm_with_ball_tip();
  testing::ArmScanSettings settings_;
  testing::ArmScan scan_;
  std::string text_;
  RecordedScan source_;
  Recording recording_;
  testing::TemporaryFolder folder_;
};

TEST_F(ScanReadings, TellsTheBallOfEachPointWithANominalArm) {
  int used = 0;
  int on_balls = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    scan(seed);
    const auto constraints = read();
    ASSERT_TRUE(constraints) << constraints.error().text();
    for (std::size_t i = 0; i < recording_.readings.size(); ++i) {
      const auto row = static_cast<std::size_t>(recording_.readings[i].line - 1);
      ASSERT_EQ(recording_.features.name(recording_.readings[i].feature),
                std::string(1, static_cast<char>('A' + scan_.labels[row])))
          << "seed " << seed << ", row " << row;
      ASSERT_LT((recording_.joints.col(static_cast<Eigen::Index>(i)) - scan_.joints[row]).cwiseAbs().maxCoeff(), 1e-10);
    }
    used += static_cast<int>(recording_.readings.size());
    on_balls += count_of(0) + count_of(1) + count_of(2);
  }
  EXPECT_GE(used, 0.99 * on_balls);
}

// Errors of 1.2 mm and 0.4 degrees: the nominal arm sees balls that are not round.
TEST_F(ScanReadings, BallsBentByTheNominalArmAreFoundWhole) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    scan(seed, 4.0);
    ASSERT_EQ(refusal(), "accepted") << seed;
    EXPECT_GE(static_cast<int>(recording_.readings.size()), 0.97 * (count_of(0) + count_of(1) + count_of(2))) << seed;
  }
}

TEST_F(ScanReadings, SimulatedTouchesAreOnTheBalls) {
  settings_.noise = 0.0;
  const Arm truth = testing::planted_errors(arm_, 1);
  const auto exact = testing::scan_with_arm(truth, settings_);
  const testing::ArmNumbers<double> numbers(truth);
  const auto tip = [&](std::size_t i) {
    return testing::tip_in_base(numbers, std::vector<double>(exact.joints[i].begin(), exact.joints[i].end()), 0);
  };
  // Two points of a sphere and the last ball's pole are enough to see a wrong radius or a wrong arm.
  EXPECT_LT((tip(0) - tip(1)).norm(), 2.0 * 15.7);
  EXPECT_NEAR((tip(210) - tip(0)).norm(), 250.0, 5.0);
}

TEST_F(ScanReadings, ReadingsCarryTheLabelsOfTheScan) {
  source_.temperature = 21.5;
  scan(2);
  ASSERT_TRUE(read());
  const Reading& first = recording_.readings.front();
  EXPECT_EQ(recording_.placements.name(first.placement), "left");
  EXPECT_EQ(first.temperature, 21.5);
  EXPECT_EQ(recording_.files[static_cast<std::size_t>(first.file)], source_.path);
  EXPECT_EQ(recording_.inputs.back().sha256, sha256(text_));
  EXPECT_THAT(recording_.warnings, SizeIs(1));
  EXPECT_THAT(recording_.warnings.back(), HasSubstr("450 of 630 points became readings: A 150, B 150, C 150"));
}

TEST_F(ScanReadings, ThinsOnlyWhereAsked) {
  source_.use_every = 10;
  scan(2);
  ASSERT_TRUE(read());
  EXPECT_THAT(recording_.readings, SizeIs(45));
  EXPECT_THAT(recording_.warnings.back(), HasSubstr("45 of 630 points became readings (use_every = 10)"));
}

TEST_F(ScanReadings, ForVerificationEveryPointOfABallIsTakenByTheArmInQuestion) {
  settings_.noise = 0.1;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    scan(seed);
    const Arm truth = testing::planted_errors(testing::arm_with_ball_tip(), seed);
    const auto constraints = read({ScanUse::WholeBalls, &truth});
    ASSERT_TRUE(constraints) << constraints.error().text();
    for (std::size_t i = 0; i < recording_.readings.size(); ++i) {
      const auto row = static_cast<std::size_t>(recording_.readings[i].line - 1);
      ASSERT_EQ(recording_.features.name(recording_.readings[i].feature),
                std::string(1, static_cast<char>('A' + scan_.labels[row])))
          << "seed " << seed << ", row " << row;
    }
    EXPECT_GE(static_cast<int>(recording_.readings.size()), 0.8 * (count_of(0) + count_of(1) + count_of(2)));
  }
}

TEST_F(ScanReadings, CoordinatesAloneAreForVerification) {
  scan(2);
  text_ = "x y z\n";
  const Eigen::Vector3d towards(0.6, 0.0, 0.8);
  RandomStream random(1, "coordinates");
  for (const double place : settings_.places) {
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d at = place * towards + 15.7 * random.direction();
      text_ += fmt::format("{} {} {}\n", at.x(), at.y(), at.z());
    }
  }
  EXPECT_THAT(refusal(), HasSubstr("scan.txt: the scan has no joint angles"));
  ASSERT_TRUE(read({ScanUse::WholeBalls, nullptr}));
  ASSERT_THAT(recording_.readings, SizeIs(900));
  EXPECT_NEAR((recording_.readings.back().tip - 600.0 * towards).norm(), 15.7, 1e-3);
  EXPECT_FALSE(recording_.joints.col(0).allFinite());
}

TEST_F(ScanReadings, OrientationAndRepeatReachTheReadings) {
  source_.orientation = "down";
  source_.repeat = "2";
  scan(2);
  ASSERT_TRUE(read());
  EXPECT_EQ(recording_.orientations.name(recording_.readings.back().orientation), "down");
  EXPECT_EQ(recording_.repeats.name(recording_.readings.back().repeat), "2");
}

TEST_F(ScanReadings, ASymmetricBarNeedsAPlace) {
  settings_.places = {0.0, 300.0, 600.0};
  scan(3);
  EXPECT_THAT(refusal(), HasSubstr("scan.txt: the certified distances fit the spheres in 2 ways"));
  source_.places = {{"A", nominal_tip(0)}};
  ASSERT_TRUE(read());
  EXPECT_EQ(recording_.features.name(recording_.readings.front().feature), "A");
  EXPECT_EQ(scan_.labels[static_cast<std::size_t>(recording_.readings.front().line - 1)], 0);
  source_.places.front().sphere = "Z";
  EXPECT_THAT(refusal(), HasSubstr("where the sphere \"Z\" is, which the artefact \"bar\" does not have"));
}

TEST_F(ScanReadings, ABallThatIsNotThereIsSaid) {
  scan(4);
  std::string short_text;
  std::size_t row = 0;
  for (std::size_t at = 0; at < text_.size();) {
    const std::size_t end = text_.find('\n', at) + 1;
    if (row == 0 || scan_.labels[row - 1] != 1) short_text += text_.substr(at, end - at);
    at = end;
    ++row;
  }
  text_ = short_text;
  // One distance is left, and it reads the same from both ends.
  EXPECT_THAT(refusal(), HasSubstr("fit the spheres in 2 ways"));
  source_.places = {{"A", nominal_tip(0)}};
  ASSERT_TRUE(read());
  EXPECT_THAT(recording_.warnings.back(), HasSubstr("Not found: B"));
  EXPECT_EQ(recording_.features.find("B"), -1);
}

TEST_F(ScanReadings, RefusesWhatCannotBeReadings) {
  scan(5);
  const std::string whole = text_;
  text_ = replaced(whole, " q6\n", " other\n");
  EXPECT_THAT(refusal(), HasSubstr("scan.txt: the scan has joint angles q1 … q5, but the arm"));
  text_ = "x y z\n0 0 0\n1 0 0\n";
  EXPECT_THAT(refusal(), HasSubstr("scan.txt: the scan has no joint angles"));
  text_ = "";
  EXPECT_THAT(refusal(), HasSubstr("scan.txt"));
  text_ = whole;
  arm_.joints[2].d += 300.0;
  EXPECT_THAT(refusal(), HasSubstr("scan.txt: "));
  arm_ = testing::arm_with_ball_tip();
  source_.probe = "stylus";
  EXPECT_THAT(refusal(), HasSubstr("recording.toml:5: the scan names the probe \"stylus\""));
  source_.probe.clear();
  source_.artefact = "plate";
  EXPECT_THAT(refusal(), HasSubstr("recording.toml:5: the scan names the artefact \"plate\", expected one of: bar"));
  source_.artefact.clear();
  EXPECT_EQ(refusal(), "accepted");
  settings_.places = {0.0, 270.0, 700.0};
  EXPECT_THAT(refusal(), HasSubstr("they are not at the certified distances to 10 mm"));
}

// A recording that is bound stays as it was read, so that it can be bound again, to the same readings.
TEST_F(ScanReadings, ARecordingIsBoundAsOftenAsIsWanted) {
  scan(6);
  ASSERT_TRUE(read());
  Recording as_read;
  as_read.arm = arm_;
  as_read.scans = {source_};
  as_read.artefact_paths = recording_.artefact_paths;
  const auto first = bind_recording(as_read);
  const auto second = bind_recording(as_read);
  ASSERT_TRUE(first && second);
  EXPECT_THAT(as_read.readings, SizeIs(0));
  EXPECT_THAT(as_read.inputs, SizeIs(0));
  EXPECT_EQ(first->recording.readings.size(), recording_.readings.size());
  EXPECT_EQ(second->recording.readings.size(), recording_.readings.size());
  EXPECT_EQ(second->recording.joints, recording_.joints);
}

TEST_F(ScanReadings, RefusesAScanNamedTwice) {
  scan(6);
  ASSERT_TRUE(read());
  recording_.scans.push_back(recording_.scans.front());
  const auto again = bind_recording(recording_);
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().text(), HasSubstr("is named twice"));
}

}  // namespace
}  // namespace artcal
