#include "artefacts/verification/interim.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/random.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<TestValue> values(const std::string& placement, const std::vector<double>& micrometres) {
  std::vector<TestValue> all;
  for (const double error : micrometres) {
    TestValue value;
    value.artefact = "bar";
    value.placement = placement;
    value.first = "A";
    value.second = "B";
    value.certified = 500.0;
    value.value = 1e-3 * error;
    value.budget = {3e-3, 0.0, 1e-3, 0.0, 0.0, 0.0};
    all.push_back(value);
  }
  return all;
}

// Means 10 and 16, squares 2 + 2 on 2 + 2 degrees of freedom: s = 1; u² = 1 + 1 + 1·(1/3 + 1/3).
TEST(Interim, IsWorkedOutByHand) {
  const InterimCheck check = compare(values("1", {15, 16, 17}), values("1", {9, 10, 11}));
  ASSERT_EQ(check.drifts.size(), 1u);
  EXPECT_NEAR(check.drifts[0].drift, 6e-3, 1e-12);
  EXPECT_EQ(check.drifts[0].degrees_of_freedom, 4);
  EXPECT_NEAR(check.drifts[0].repeatability, 1e-3, 1e-12);
  EXPECT_NEAR(check.drifts[0].u, 1e-3 * std::sqrt(2.0 + 2.0 / 3.0), 1e-12);
  EXPECT_TRUE(check.drifts[0].significant);
  EXPECT_TRUE(check.any_significant());
}

TEST(Interim, AnotherCertificateDoesNotCancel) {
  auto before = values("1", {9, 10, 11});
  for (TestValue& value : before) value.certified = 500.001;
  const InterimCheck check = compare(values("1", {15, 16, 17}), before);
  EXPECT_NEAR(check.drifts[0].u, 1e-3 * std::sqrt(20.0 + 2.0 / 3.0), 1e-12);
  EXPECT_FALSE(check.any_significant());
}

TEST(Interim, WithoutRepeatsNothingIsSignificant) {
  const InterimCheck check = compare(values("1", {500}), values("1", {10}));
  EXPECT_EQ(check.drifts[0].degrees_of_freedom, 0);
  EXPECT_FALSE(check.any_significant());
  EXPECT_FALSE(check.any_told());
}

// The scatter of lengths says nothing of a ball's diameter.
TEST(Interim, RepeatabilityIsTheQuantitysOwn) {
  auto before = values("1", {9, 10, 11});
  auto after = values("1", {9, 10, 11});
  for (auto* all : {&before, &after}) {
    all->push_back(values("1", {5}).front());
    all->back().quantity = Quantity::SizeError;
  }
  const InterimCheck check = compare(after, before);
  ASSERT_EQ(check.drifts.size(), 2u);
  EXPECT_EQ(check.drifts[0].degrees_of_freedom, 0);
  EXPECT_NEAR(check.drifts[0].u, 1e-3 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(check.drifts[1].degrees_of_freedom, 4);
}

TEST(Interim, OnlyTheSamePlacementIsCompared) {
  const InterimCheck check = compare(values("2", {15, 16}), values("1", {9, 10}));
  EXPECT_TRUE(check.drifts.empty());
  EXPECT_THAT(check.not_compared, ElementsAre(HasSubstr("placement 2")));
}

// An arm that did not change is accused in about one check of twenty.
TEST(Interim, FalseAlarmsAreAsRareAsPromised) {
  RandomStream random(3, "interim");
  int alarms = 0;
  constexpr int count = 20000;
  const auto draw = [&](int n) {
    std::vector<double> errors;
    for (int i = 0; i < n; ++i) errors.push_back(10.0 + 4.0 * random.normal());
    auto all = values("1", errors);
    for (TestValue& value : all) value.budget = {};
    return all;
  };
  for (int i = 0; i < count; ++i) {
    alarms += compare(draw(5), draw(5)).any_significant() ? 1 : 0;
  }
  // Student's factor to its first term only: with 8 degrees of freedom 2.26 for 2.31.
  EXPECT_NEAR(static_cast<double>(alarms) / count, 0.05, 0.01);
}

}  // namespace
}  // namespace artcal
