#include "artefacts/verification/b89_4_22/b89_4_22.h"

#include <gmock/gmock.h>

#include "tests/support/reported_readings.h"

namespace artcal {
namespace {

using testing::ball;
using ::testing::Contains;
using ::testing::HasSubstr;

Artefact seat() {
  Artefact artefact;
  artefact.name = "seat";
  artefact.features.resize(1);
  artefact.features[0].name = "seat";
  return artefact;
}

Artefact bar() {
  Artefact artefact;
  artefact.name = "bar";
  artefact.features = {ball("1", 25.0), ball("2", 25.0)};
  artefact.distances = {{0, 1, 500.0, 0.3e-3}};
  artefact.expansion_is_known = true;
  return artefact;
}

Artefact single() {
  Artefact artefact;
  artefact.name = "ball";
  artefact.features = {ball("ball", 25.0)};
  return artefact;
}

// Four readings of a seat at (±3, 0, 0) and (0, ±4, 0) µm: maximum 4, 2·√(50/3), half ranges 3, 4, 0.
TEST(B89, ArticulationIsWorkedOutByHand) {
  testing::ReportedReadings readings;
  for (const auto& off :
       {Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(-3, 0, 0), Eigen::Vector3d(0, 4, 0), Eigen::Vector3d(0, -4, 0)}) {
    readings.add({"seat", "1", "seat", "", ""}, Eigen::Vector3d(500.0, 400.0, 300.0) + 1e-3 * off);
  }
  const testing::SessionMaterial material(readings.recording(), {seat()}, {});
  const B89Verification result = verify_b89_4_22(material.session()).value();
  ASSERT_EQ(result.articulations.size(), 1u);
  const Articulation& spat = result.articulations[0];
  EXPECT_NEAR(spat.largest, 0.004, 1e-12);
  EXPECT_NEAR(spat.twice_s, 2e-3 * std::sqrt(50.0 / 3.0), 1e-12);
  EXPECT_NEAR((spat.half_range - Eigen::Vector3d(0.003, 0.004, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(result.verification.values.size(), 2u);
  EXPECT_FALSE(result.volumetric);
}

// Errors +10, -20, +40 µm: at most 40, range 60, RMS about zero √700, s √((900 − ...)): by hand below.
TEST(B89, VolumetricFiguresAreToldApart) {
  testing::ReportedReadings readings;
  RandomStream random(1, "b89");
  const std::vector<double> errors{0.010, -0.020, 0.040};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const std::string placement = std::to_string(i);
    readings.touch_ball({"bar", placement, "1", "", ""}, {300.0, 300.0, 0.0}, 12.5, testing::pattern_5(), 0.0, random);
    readings.touch_ball({"bar", placement, "2", "", ""}, {800.0 + errors[i], 300.0, 0.0}, 12.5, testing::pattern_5(),
                        0.0, random);
  }
  Specification by;
  by.plan = TestPlan{};
  by.plan->volumetric_lengths = 20;
  const testing::SessionMaterial material(readings.recording(), {bar()}, by);
  const B89Verification result = verify_b89_4_22(material.session()).value();
  ASSERT_TRUE(result.volumetric);
  EXPECT_NEAR(result.volumetric->largest, 0.040, 1e-9);
  EXPECT_NEAR(result.volumetric->range, 0.060, 1e-9);
  EXPECT_NEAR(result.volumetric->twice_rms, 2e-3 * std::sqrt(2100.0 / 3.0), 1e-9);
  EXPECT_NEAR(result.volumetric->twice_s, 2e-3 * 30.0, 1e-9);  // mean 10; deviations 0, -30, 30; 1800/2
  EXPECT_THAT(result.verification.missing, Contains(HasSubstr("volumetric, lengths: 3 of 20")));
}

TEST(B89, EffectiveDiameterOfThreeRepeats) {
  testing::ReportedReadings readings;
  RandomStream random(1, "b89");
  for (const char* repeat : {"1", "2", "3"}) {
    readings.touch_ball({"ball", "1", "ball", "", repeat}, {300.0, 300.0, 0.0}, 12.506, testing::pattern_25(), 0.0,
                        random);
  }
  Specification by;
  by.limits = {{Quantity::EffectiveDiameter, {0.010, 0.0, {}}}};
  const testing::SessionMaterial material(readings.recording(), {single()}, by);
  const B89Verification result = verify_b89_4_22(material.session()).value();
  ASSERT_EQ(result.verification.values.size(), 3u);
  EXPECT_NEAR(result.verification.values[0].value, 0.012, 1e-9);
  EXPECT_EQ(result.verification.values[0].verdict, Verdict::NonConformityProven);
  EXPECT_EQ(result.verification.conclusion, Conclusion::NonConformityProven);
}

}  // namespace
}  // namespace artcal
