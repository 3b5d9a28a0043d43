#include "artefacts/constraints/coincident_readings.h"

#include <gmock/gmock.h>

#include "core/random.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Artefact artefact_of(FeatureKind kind) {
  Artefact artefact;
  artefact.name = "bar";
  CertifiedFeature first;
  first.name = "A";
  first.kind = kind;
  CertifiedFeature second = first;
  second.name = "B";
  artefact.features = {first, second};
  return artefact;
}

/// Readings of a two-joint arm: joints, and on which feature, in which repeat.
class Readings {
 public:
  Readings() {
    recording_.files = {"r.csv"};
    recording_.arm.probes.resize(1);
  }
  Reading& add(const Eigen::Vector2d& joints, const std::string& feature, const std::string& repeat) {
    Reading reading;
    reading.artefact = recording_.artefacts.index_of("bar");
    reading.placement = recording_.placements.index_of("1");
    reading.feature = recording_.features.index_of(feature);
    reading.orientation = recording_.orientations.index_of("");
    reading.repeat = recording_.repeats.index_of(repeat);
    reading.line = static_cast<int>(recording_.readings.size()) + 2;
    recording_.readings.push_back(reading);
    recording_.joints.conservativeResize(2, recording_.joints.cols() + 1);
    recording_.joints.rightCols<1>() = joints;
    return recording_.readings.back();
  }
  Recording& recording() { return recording_; }

 private:
  Recording recording_;
};

std::vector<int> lines_of(const Recording& recording) {
  std::vector<int> lines;
  for (const Reading& reading : recording.readings) lines.push_back(reading.line);
  return lines;
}

TEST(CoincidentReadings, OneMeasurementCountsOnceUnderAnyLabel) {
  Readings readings;
  readings.add({0.1, 0.2}, "A", "1");               // 2
  readings.add({0.3, 0.4}, "A", "1");               // 3
  readings.add({0.1, 0.2}, "A", "1");               // 4: the row again
  readings.add({0.1, 0.2 + 1e-12}, "A", "2");       // 5: as another repeat, by way of another unit
  readings.add({0.1, 0.2}, "B", "1");               // 6: on another feature; contradicts, but does not repeat
  readings.add({0.1, 0.2}, "A", "1").length = 5.0;  // 7: something else was measured
  readings.add({0.1, 0.2 + 1e-6}, "A", "1");        // 8: a step of an encoder apart
  drop_coincident_readings(readings.recording(), {artefact_of(FeatureKind::Sphere)});
  EXPECT_THAT(lines_of(readings.recording()), ElementsAre(2, 3, 6, 7, 8));
  EXPECT_EQ(readings.recording().joints.cols(), 5);
  EXPECT_THAT(
      readings.recording().warnings,
      ElementsAre(HasSubstr("2 of 7 readings repeat an earlier one in every number (r.csv:4 repeats r.csv:2)")));
  EXPECT_EQ(readings.recording().repeated_readings, readings.recording().warnings.front());
  drop_coincident_readings(readings.recording(), {artefact_of(FeatureKind::Sphere)});
  EXPECT_EQ(readings.recording().warnings.size(), 1u);
}

// Coordinates alone, in whole hundredths of a millimetre.
Recording reported(const std::vector<Eigen::Vector3d>& tips) {
  Readings readings;
  for (const Eigen::Vector3d& tip : tips) {
    readings.add({NAN, NAN}, "A", "").tip = tip;
  }
  return readings.recording();
}

TEST(CoincidentReadings, ResolutionExplainsAFewInASeat) {
  std::vector<Eigen::Vector3d> tips;
  for (int i = 0; i < 9; ++i) tips.emplace_back(0.01 * i, 0.0, 0.0);
  tips.push_back(tips.front());
  Recording one_of_ten = reported(tips);
  drop_coincident_readings(one_of_ten, {artefact_of(FeatureKind::Point)});
  EXPECT_EQ(one_of_ten.readings.size(), 10u);
  EXPECT_THAT(one_of_ten.warnings, IsEmpty());
  EXPECT_EQ(one_of_ten.repeated_readings, std::nullopt);
  // On a ball no two touches agree; and in a seat not half of them.
  Recording on_ball = reported(tips);
  drop_coincident_readings(on_ball, {artefact_of(FeatureKind::Sphere)});
  EXPECT_EQ(on_ball.readings.size(), 9u);
  tips.insert(tips.end(), tips.begin(), tips.begin() + 9);
  Recording twice = reported(tips);
  drop_coincident_readings(twice, {artefact_of(FeatureKind::Point)});
  EXPECT_EQ(twice.readings.size(), 9u);
}

}  // namespace
}  // namespace artcal
