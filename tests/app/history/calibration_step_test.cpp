#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/history/arm_history.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// a6 held, a length and an angle identified, correlated by `rho`.
Calibration calibration(double length, double angle, double rho = 0.0, double fixed = 0.0) {
  Calibration made;
  made.parameters = {{"a1", "mm", "identified", length, 0.03},
                     {"theta2", "rad", "identified", angle, 4e-5},
                     {"a6", "mm", "fixed", fixed, 0.0}};
  made.covariance.resize(2, 2);
  made.covariance << 0.03 * 0.03, rho * 0.03 * 4e-5, rho * 0.03 * 4e-5, 4e-5 * 4e-5;
  made.entry.certificates = {"bar 1", "bar 2"};
  return made;
}

TEST(CalibrationStep, ChangesAreHeldAgainstTheirCombinedUncertainty) {
  // √(0.03² + 0.03²) = 0.0424: 0.05 is 1.18 of these. √2·4e-5 = 5.66e-5: 1.5e-4 is 2.65 of these.
  const auto step = step_between(calibration(10.0, 0.0), calibration(10.05, 1.5e-4));
  ASSERT_EQ(step.changes.size(), 2u);
  EXPECT_NEAR(step.changes[0].u, 0.0424264, 1e-7);
  EXPECT_FALSE(step.changes[0].significant);
  EXPECT_NEAR(step.changes[1].u, 5.65685e-5, 1e-10);
  EXPECT_TRUE(step.changes[1].significant);
  // 1.388889 + 7.03125, against the 95 % quantile of χ² with two degrees of freedom, −2·ln 0.05.
  EXPECT_NEAR(step.chi_squared, 8.4201389, 1e-6);
  EXPECT_NEAR(step.limit, -2.0 * std::log(0.05), 1e-9);
  EXPECT_TRUE(step.significant());
  EXPECT_THAT(step.in_common, ElementsAre("bar 1", "bar 2"));
}

TEST(CalibrationStep, CorrelatedParametersAreJudgedTogether) {
  // Each by itself stays within 2 u; along the direction that the readings tell best they do not.
  const auto step = step_between(calibration(10.0, 0.0, 0.98), calibration(10.06, -8e-5, 0.98));
  EXPECT_FALSE(step.changes[0].significant);
  EXPECT_FALSE(step.changes[1].significant);
  // x = √2, y = −√2 in units of u: (x² − 2ρxy + y²)/(1 − ρ²) = 4·1.98/(1 − 0.9604)·… = 200.
  EXPECT_NEAR(step.chi_squared, (2.0 + 2.0 * 0.98 * 2.0 + 2.0) / (1.0 - 0.98 * 0.98), 1e-6);
  EXPECT_TRUE(step.significant());
}

// theta2 turns about the end of a link of 100 mm, whose a6 no reading tells apart from it.
TEST(CalibrationStep, APartnerFixedElsewhereIsMovedBack) {
  const auto with_partner = [](Calibration made) {
    made.unidentifiable.resize(3, 1);
    made.unidentifiable << 0.0, -1.0 / 100.0, 1.0;
    return made;
  };
  const Calibration then = with_partner(calibration(10.0, 0.0));
  const auto same = step_between(then, with_partner(calibration(10.0, -5e-4, 0.0, 0.05)));
  EXPECT_THAT(same.not_comparable, ::testing::IsEmpty());
  EXPECT_THAT(same.moved, ElementsAre("a6"));
  EXPECT_NEAR(same.changes[1].now, 0.0, 1e-15);
  EXPECT_FALSE(same.significant());
  const auto drifted = step_between(then, with_partner(calibration(10.0, 0.0, 0.0, 0.05)));
  EXPECT_NEAR(drifted.changes[1].now, 5e-4, 1e-15);
  EXPECT_TRUE(drifted.changes[1].significant);
  // The other of the pair was fixed: a6 = 0.05 mm takes over the angle with its u.
  Calibration other = calibration(10.0, 0.0, 0.0, 0.05);
  other.parameters[1] = {"theta2", "rad", "fixed", 0.0};
  other.parameters[2] = {"a6", "mm", "identified", 0.05, 4e-3};
  other.covariance(1, 1) = 16e-6;
  const auto swapped = step_between(then, with_partner(other));
  EXPECT_THAT(swapped.not_comparable, ::testing::IsEmpty());
  EXPECT_NEAR(swapped.changes[1].now, 5e-4, 1e-15);
  EXPECT_NEAR(swapped.changes[1].u, std::hypot(4e-5, 4e-5), 1e-12);
}

TEST(CalibrationStep, WhatMeansSomethingElseIsNotCompared) {
  EXPECT_THAT(step_between(calibration(10.0, 0.0), calibration(10.0, 0.0, 0.0, 0.05)).not_comparable,
              HasSubstr("a6 was fixed at 0 and then at 0.05 mm"));
  Calibration other = calibration(10.0, 0.0);
  other.parameters[2].state = "identified";
  EXPECT_THAT(step_between(calibration(10.0, 0.0), other).not_comparable, HasSubstr("a6 was identified in one"));
  other.parameters.pop_back();
  EXPECT_THAT(step_between(calibration(10.0, 0.0), other).not_comparable, HasSubstr("other parameters"));
}

}  // namespace
}  // namespace artcal
