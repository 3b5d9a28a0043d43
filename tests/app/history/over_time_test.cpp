#include "app/history/over_time.h"

#include <cmath>

#include <gtest/gtest.h>

namespace artcal {
namespace {

TestValue length(const std::string& placement, const std::string& repeat, double error, double u) {
  TestValue value;
  value.artefact = "bar";
  value.placement = placement;
  value.first = "A";
  value.second = "B";
  value.repeat = repeat;
  value.value = error;
  value.budget.calibration = u;
  value.limit = 0.05;
  return value;
}

PastVerification verification(std::vector<TestValue> values) {
  PastVerification past;
  past.standard = "iso10360-12";
  past.values = std::move(values);
  return past;
}

TEST(OverTime, RepeatsAreTakenTogetherAndSetAsideOnesAreNot) {
  ArmHistory history;
  history.verifications.push_back(
      verification({length("1", "a", 0.010, 0.003), length("1", "b", 0.014, 0.003), length("2", "a", -0.020, 0.003),
                    length("2", "b", -0.026, 0.003), length("2", "c", -0.5, 0.003)}));
  history.verifications[0].values.back().set_aside = true;
  history.verifications.push_back(verification({length("1", "a", 0.031, 0.004)}));
  const auto values = values_over_time(history);
  ASSERT_EQ(values.size(), 2u);
  ASSERT_EQ(values[0].points.size(), 2u);
  EXPECT_EQ(values[0].points[0].repeats, 2);
  EXPECT_NEAR(values[0].points[0].value, 0.012, 1e-12);
  // Off their means by 2, 2, 3 and 3 um with two degrees of freedom: s² = 26/2 um², of a mean of two 13/2.
  EXPECT_NEAR(values[0].points[0].u, std::sqrt(9e-6 + 6.5e-6), 1e-12);
  // Of 6.5 of 15.5 um² with two degrees of freedom: 2·(15.5/6.5)² = 11.373; the 97.5 % point of t(11.373)
  // by Simpson's rule: 2.192215.
  EXPECT_NEAR(values[0].points[0].coverage_factor, 2.192215, 1e-6);
  EXPECT_EQ(values[0].points[1].coverage_factor, 2.0);
  // Not repeated: the test's own uncertainty is all that is known.
  EXPECT_NEAR(values[0].points[1].u, 0.004, 1e-12);
  EXPECT_EQ(values[0].points[1].verification, 1u);
  ASSERT_EQ(values[1].points.size(), 1u);
  EXPECT_NEAR(values[1].points[0].value, -0.023, 1e-12);
}

TEST(OverTime, TheWorstIsTheNearestToItsLimit) {
  ArmHistory history;
  history.verifications.push_back(verification({length("1", "a", 0.030, 0.0), length("2", "a", -0.020, 0.0)}));
  history.verifications[0].values[1].limit = 0.021;
  const auto worst = worst_over_time(history);
  ASSERT_EQ(worst.size(), 1u);
  EXPECT_EQ(worst[0].points.at(0).value->placement, "2");
}

TEST(OverTime, StandardsAreKeptApart) {
  ArmHistory history;
  history.verifications.push_back(verification({length("1", "a", 0.030, 0.0)}));
  history.verifications.push_back(verification({length("1", "a", 0.040, 0.0)}));
  history.verifications[1].standard = "b89.4.22";
  EXPECT_EQ(values_over_time(history).size(), 2u);
  EXPECT_EQ(worst_over_time(history).size(), 2u);
}

TEST(OverTime, WhatWasNotRepeatedIsNotCalledUnchanged) {
  VerificationStep step;
  step.check.drifts.resize(3);
  EXPECT_EQ(change_in_words(step), "without repeats nothing can be called significant");
  step.check.drifts[0].degrees_of_freedom = 4;
  EXPECT_EQ(change_in_words(step), "no significant change of 1 values; 2 that were not repeated are not judged");
}

}  // namespace
}  // namespace artcal
