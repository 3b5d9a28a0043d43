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
  EXPECT_FALSE(check.any_judged());
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

// An arm that did not change is accused in one check of twenty, however few the repeats. The deviation of `now` may
// differ.
double share_of_false_alarms(int repeats_then, int repeats_now, double worse_now = 1.0) {
  RandomStream random(3, "interim");
  int alarms = 0;
  constexpr int count = 20000;
  const auto draw = [&](int n, double deviation) {
    std::vector<double> errors;
    for (int i = 0; i < n; ++i) errors.push_back(10.0 + deviation * random.normal());
    auto all = values("1", errors);
    for (TestValue& value : all) value.budget = {};
    return all;
  };
  for (int i = 0; i < count; ++i) {
    const auto then = draw(repeats_then, 4.0);
    alarms += compare(draw(repeats_now, 4.0 * worse_now), then).any_significant() ? 1 : 0;
  }
  return static_cast<double>(alarms) / count;
}

// Standard deviation of a share of 5 % among 20,000: 0.15 %.
TEST(Interim, FalseAlarmsAreAsRareAsPromised) {
  EXPECT_NEAR(share_of_false_alarms(5, 5), 0.05, 0.005);
  EXPECT_NEAR(share_of_false_alarms(2, 2), 0.05, 0.005);
  EXPECT_NEAR(share_of_false_alarms(2, 1), 0.05, 0.005);
  EXPECT_NEAR(share_of_false_alarms(1, 3), 0.05, 0.005);
  EXPECT_NEAR(share_of_false_alarms(10, 3), 0.05, 0.005);
}

// Ten values that have not changed: one of them is called changed in one check of twenty, not in four of ten.
TEST(Interim, ManyValuesAreNoMoreAlarms) {
  RandomStream random(5, "interim");
  int alarms = 0;
  constexpr int count = 4000;
  const auto session = [&] {
    std::vector<TestValue> all;
    for (int placement = 0; placement < 10; ++placement) {
      for (TestValue value : values(std::to_string(placement), {random.normal(), random.normal(), random.normal()})) {
        value.budget = {};
        all.push_back(value);
      }
    }
    return all;
  };
  for (int i = 0; i < count; ++i) {
    const auto then = session();
    alarms += compare(session(), then).any_significant() ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(alarms) / count, 0.05, 0.012);  // standard deviation 0.0034
}

// A bumped arm may scatter about the same means: ten times the scatter is a change of the arm (F test at 0.1 %).
TEST(Interim, AnArmThatScattersMoreHasChanged) { EXPECT_GT(share_of_false_alarms(10, 3, 10.0), 0.85); }

// One degree of freedom: 12.71. Of u, half of whose variance is the budgets', 2² / 1 = 4: 2.776 (JCGM 100, table G.2).
TEST(Interim, CoverageIsStudentsAndTheBudgetsCount) {
  auto before = values("1", {9, 11});  // s² = 2, of the drift 2·(1/2 + 1) = 3
  auto after = values("1", {50});
  for (auto* all : {&before, &after}) {
    for (TestValue& value : *all) value.budget = {};
  }
  const Drift alone = compare(after, before).drifts.at(0);
  EXPECT_EQ(alone.degrees_of_freedom, 1);
  EXPECT_NEAR(alone.coverage, 12.706, 1e-3);
  for (auto* all : {&before, &after}) {
    for (TestValue& value : *all) value.budget = {0.0, 0.0, 1e-3 * std::sqrt(1.5), 0.0, 0.0, 0.0};
  }
  const Drift both = compare(after, before).drifts.at(0);
  EXPECT_NEAR(both.u, 1e-3 * std::sqrt(6.0), 1e-12);
  EXPECT_NEAR(both.effective_degrees_of_freedom, 4.0, 1e-9);
  EXPECT_NEAR(both.coverage, 2.776, 1e-3);
}

}  // namespace
}  // namespace artcal
