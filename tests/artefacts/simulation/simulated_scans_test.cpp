#include <gmock/gmock.h>

#include "artefacts/simulation/simulate.h"
#include "core/units.h"
#include "tests/support/plans.h"

namespace artcal {
namespace {

using ::testing::SizeIs;

Simulation scanned(int repeats, int orientations, int points) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), points);
  plan.probings[0].scan = true;
  plan.probings[0].repeats = repeats;
  plan.probings[0].orientations = orientations;
  plan.placements[0].temperature = 21.0;
  plan.placements[0].temperature_end = 23.0;
  auto simulation = simulate(plan, 2);
  if (!simulation) throw std::runtime_error(simulation.error().text());
  EXPECT_EQ(planned_scans(plan), static_cast<int>(simulation->scans.size()));
  return std::move(*simulation);
}

TEST(SimulatedScans, APlacementARepeatAndAPostureIsOne) {
  const Simulation simulation = scanned(2, 3, 4);
  ASSERT_THAT(simulation.scans, SizeIs(6));
  for (const SimulatedScan& scan : simulation.scans) {
    ASSERT_THAT(scan.readings, SizeIs(12));
    for (std::size_t i = 0; i < 12; ++i) {
      const Reading& reading = simulation.recording.readings[static_cast<std::size_t>(scan.readings[i])];
      EXPECT_EQ(simulation.recording.features.name(reading.feature), std::string(1, static_cast<char>('A' + i / 4)));
      EXPECT_EQ(reading.orientation, scan.orientation);
      EXPECT_EQ(reading.repeat, scan.repeat);
    }
  }
}

TEST(SimulatedScans, ABallIsScannedFromOnePosture) {
  const Simulation simulation = scanned(1, 0, 60);
  ASSERT_THAT(simulation.scans, SizeIs(1));
  const Eigen::MatrixXd& joints = simulation.recording.joints;
  for (int ball = 0; ball < 3; ++ball) {
    for (int i = 0; i < 60; ++i) {
      EXPECT_LT((joints.col(60 * ball + i) - joints.col(60 * ball)).cwiseAbs().maxCoeff(), 15.0 * units::degree);
    }
  }
}

TEST(SimulatedScans, AreWrittenInPlaceOfTheirReadings) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 5);
  plan.probings.push_back(plan.probings[0]);
  plan.probings[1].scan = true;
  plan.placements[0].temperature = 21.0;
  plan.placements[0].temperature_end = 23.0;
  const auto simulation = simulate(plan, 2);
  ASSERT_TRUE(simulation);
  ASSERT_THAT(simulation->recording.readings, SizeIs(30));
  const Recording written = recording_with_scans(*simulation);
  EXPECT_THAT(written.readings, SizeIs(15));
  EXPECT_EQ(written.joints, simulation->recording.joints.leftCols(15));
  ASSERT_THAT(written.scans, SizeIs(1));
  EXPECT_EQ(written.scans[0].path, "scan-1.pcd");
  EXPECT_EQ(written.scans[0].placement, "left");
  EXPECT_EQ(written.scans[0].repeat, "");
  ASSERT_TRUE(written.scans[0].temperature);
  EXPECT_NEAR(*written.scans[0].temperature, 21.0 + 2.0 * 22.0 / 29.0, 1e-9);  // readings 15 to 29 of 30
}

}  // namespace
}  // namespace artcal
