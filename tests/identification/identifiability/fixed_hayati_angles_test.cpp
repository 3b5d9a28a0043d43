// A UR10e of a factory calibration: its axes 2, 3 and 4 are parallel to some tenths of a degree, and its d are 440 m
// that cancel. Read by an independent forward kinematics, identified from the nominal arm.
#include "identification/identifiability/fixed_hayati_angles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/recordings.h"
#include "tests/support/tracked.h"
#include "tests/support/universal_robots.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

Arm with_tip(Arm arm) {
  arm.probes[0].tip_in_last = {40.0, 0.0, 100.0};
  return arm;
}

Arm nominal_ur10e() { return with_tip(test::nominal_ur10e()); }
Arm calibrated_ur10e() { return with_tip(test::calibrated_ur10e()); }

test::Bound read_coordinates(const Arm& truth, const Arm& nominal, int count) {
  return test::tracked(truth, nominal, count, 0.0);
}

IdentifyOptions plain() {
  IdentifyOptions options;
  options.leave_out = false;
  return options;
}

// The default model: 300 readings without noise are met to rounding, where Denavit and Hartenberg's parameters alone
// end at 0.65 mm with a condition of 7e10.
TEST(HayatiAngles, OfTheDefaultModelMeetPlantedReadings) {
  const test::Bound bound = read_coordinates(calibrated_ur10e(), nominal_ur10e(), 300);
  const Identification result = test::identified(bound, plain());
  EXPECT_NEAR(result.before.overall.rms, 2.264, 0.2);  // of other postures
  EXPECT_LT(result.after.overall.rms, 2e-10);
  EXPECT_EQ(test::state_of(result, "d2"), ParameterState::Unidentifiable);
  EXPECT_EQ(test::state_of(result, "d3"), ParameterState::Unidentifiable);
  EXPECT_NEAR(test::identified_value(result, "beta2"), 1.3935e-3, 1e-7);
  EXPECT_NEAR(test::identified_value(result, "beta3"), -0.5802e-3, 1e-7);
  EXPECT_NEAR(test::identified_value(result, "alpha3"), 6.914e-3, 1e-6);
  EXPECT_NEAR(test::identified_value(result, "a2"), -612.5408, 1e-4);
}

// Begun at the calibrated arm's own numbers, d of 440 m and all: the same arm.
TEST(HayatiAngles, ReplaceLargeOffsetsOfTheNominalArm) {
  const test::Bound bound = read_coordinates(calibrated_ur10e(), calibrated_ur10e(), 100);
  IdentifyOptions options = plain();
  options.noise.reading = 0.01;
  const Identification result = test::identified(bound, options);
  EXPECT_LT(result.after.overall.rms, 1e-6);
  EXPECT_EQ(test::identified_value(result, "d2"), 0.0);
  EXPECT_NEAR(test::identified_value(result, "a2"), -612.5408, 1e-3);
}

// Denavit and Hartenberg's parameters alone, on request: never a point that is no minimum without a word.
TEST(HayatiAngles, ThatAreFixedAreSpokenOf) {
  const test::Bound bound = read_coordinates(calibrated_ur10e(), nominal_ur10e(), 150);
  IdentifyOptions options = plain();
  const auto nominal = evaluate(bound.recording, bound.constraints, bound.recording.arm);
  ASSERT_TRUE(nominal);
  EXPECT_EQ(note_on_fixed_hayati_angles(bound.recording, bound.constraints, options, *nominal), "");
  options.hold = {"beta2", "beta3"};
  const std::string note = note_on_fixed_hayati_angles(bound.recording, bound.constraints, options, *nominal);
  EXPECT_THAT(note, HasSubstr("axes 2 and 3 (0 deg), axes 3 and 4 (0 deg)"));
  EXPECT_THAT(note, HasSubstr("beta2, beta3 are fixed"));
  EXPECT_THAT(note, HasSubstr("100 % less"));
  const auto result = identify(bound.recording, bound.constraints, options);
  if (result) {
    EXPECT_TRUE(result->after.overall.rms < 1e-6 || !result->warnings.empty());
  } else {
    EXPECT_THAT(result.error().message, HasSubstr("nearly parallel"));
  }
}

}  // namespace
}  // namespace artcal
