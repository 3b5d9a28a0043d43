#include "core/statistics.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(Statistics, MedianOfOddAndEvenCounts) {
  EXPECT_EQ(median(std::array{5.0}), 5.0);
  EXPECT_EQ(median(std::array{9.0, 1.0, 5.0}), 5.0);
  EXPECT_EQ(median(std::array{9.0, 1.0, 5.0, 2.0}), 3.5);
  EXPECT_EQ(median(std::array{4.0, 4.0, 4.0, -100.0}), 4.0);
}

TEST(Statistics, MedianLeavesItsValuesAlone) {
  const std::vector<double> values{3.0, 1.0, 2.0};
  EXPECT_EQ(median(values), 2.0);
  EXPECT_EQ(values, (std::vector<double>{3.0, 1.0, 2.0}));
}

// Table of critical values: NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.4 (three decimals).
TEST(Statistics, ChiSquaredQuantilesOfTheTables) {
  EXPECT_NEAR(chi_squared_quantile(0.95, 1), 3.841, 5e-4);
  EXPECT_NEAR(chi_squared_quantile(0.99, 1), 6.635, 5e-4);
  EXPECT_NEAR(chi_squared_quantile(0.95, 3), 7.815, 5e-4);
  EXPECT_NEAR(chi_squared_quantile(0.90, 10), 15.987, 5e-4);
  EXPECT_NEAR(chi_squared_quantile(0.95, 10), 18.307, 5e-4);
  EXPECT_NEAR(chi_squared_quantile(0.05, 10), 3.940, 5e-4);
  EXPECT_NEAR(chi_squared_quantile(0.999, 30), 59.703, 5e-4);
  EXPECT_NEAR(chi_squared_quantile(0.975, 100), 129.561, 5e-4);
}

// Two degrees of freedom have a closed form: -2 log(1 - p).
TEST(Statistics, ChiSquaredQuantilesOfTwoDegreesOfFreedom) {
  for (const double probability : {0.001, 0.05, 0.5, 0.95, 0.999}) {
    EXPECT_NEAR(chi_squared_quantile(probability, 2.0), -2.0 * std::log1p(-probability), 1e-12);
  }
}

// Two-sided 95 % and 99 % points of Student's distribution: scipy 1.10 stats.t.ppf (to 1e-8); JCGM 100,
// table G.2 has two decimals. Two degrees of freedom have a closed form.
TEST(Statistics, StudentFactorsAtSmallDegreesOfFreedom) {
  EXPECT_NEAR(student_coverage_factor(0.95, 1), 12.706204736174704, 1e-7);
  EXPECT_NEAR(student_coverage_factor(0.95, 2), 4.302652729911275, 1e-7);
  EXPECT_NEAR(student_coverage_factor(0.95, 2.5), 3.5746548420118773, 1e-7);
  EXPECT_NEAR(student_coverage_factor(0.95, 3), 3.182446305284263, 1e-7);
  EXPECT_NEAR(student_coverage_factor(0.95, 5), 2.5705818366147395, 1e-7);
  EXPECT_NEAR(student_coverage_factor(0.95, 100), 1.9839715184496334, 1e-7);
  EXPECT_NEAR(student_coverage_factor(0.99, 1), 63.65674116287399, 1e-6);
  EXPECT_NEAR(student_coverage_factor(0.99, 3), 5.84090929975643, 1e-7);
  EXPECT_NEAR(student_coverage_factor(0.95, INFINITY), 1.959963984540054, 1e-12);
}

// JCGM 100, table G.2 at 95 %: 12.71, 2.57, 2.23 for 1, 5 and 10 degrees of freedom.
TEST(Statistics, StatedCoverageFactorsAreTwoOrStudents) {
  EXPECT_NEAR(stated_coverage_factor(1), 12.71, 0.01);
  EXPECT_NEAR(stated_coverage_factor(5), 2.57, 0.01);
  EXPECT_NEAR(stated_coverage_factor(10), 2.23, 0.01);
  EXPECT_EQ(stated_coverage_factor(100), 2.0);
  EXPECT_EQ(stated_coverage_factor(INFINITY), 2.0);
}

// scipy 1.10: norm.isf(0.025/20), t.isf(0.025, 1), t.isf(0.0125, 5).
TEST(Statistics, SignificanceCountsWhatIsLookedAt) {
  EXPECT_NEAR(significance_factor(20, INFINITY), 3.0233414, 1e-6);
  EXPECT_NEAR(significance_factor(1, 1), 12.7062047, 1e-6);
  EXPECT_NEAR(significance_factor(2, 5), 3.1633815, 1e-6);
}

// A normal variable exceeds 4 once in 31,574: scipy 1.10 stats.t.isf(stats.norm.sf(4), ...).
TEST(Statistics, StudentLimitsAsRareAsFourSigma) {
  EXPECT_NEAR(student_limit_as_rare_as(4.0, 1) / 10050.439032475448, 1.0, 1e-7);
  EXPECT_NEAR(student_limit_as_rare_as(4.0, 2) / 125.64112687430162, 1.0, 1e-7);
  EXPECT_NEAR(student_limit_as_rare_as(4.0, 5) / 12.281424348286638, 1.0, 1e-7);
  EXPECT_EQ(student_limit_as_rare_as(4.0, INFINITY), 4.0);
}

// scipy 1.10 stats.f.isf; NIST/SEMATECH e-Handbook 1.3.6.7.3 has 9.277 for 5 % with (3, 3) and 5.409 with (3, 5).
TEST(Statistics, FisherLimitsAtSmallDegreesOfFreedom) {
  EXPECT_NEAR(f_quantile_above(0.05, 1, 1), 161.44763879758827, 1e-8);
  EXPECT_NEAR(f_quantile_above(0.05, 3, 1), 215.70734536960882, 1e-8);
  EXPECT_NEAR(f_quantile_above(0.05, 3, 2), 19.164292127511278, 1e-9);
  EXPECT_NEAR(f_quantile_above(0.05, 3, 3), 9.276628153144804, 1e-9);
  EXPECT_NEAR(f_quantile_above(0.05, 3, 5), 5.40945131805649, 1e-9);
  EXPECT_NEAR(f_quantile_above(0.01, 3, 2), 99.16620137447148, 1e-8);
  EXPECT_NEAR(f_quantile_above(0.01, 3, 60), 4.125891930795666, 1e-9);
  EXPECT_NEAR(f_quantile_above(0.01 / 9.0, 3, 4), 53.21429164315051, 1e-8);
}

// scipy.stats.chi2.sf, scipy 1.10.
TEST(Statistics, ProbabilitiesOfChiSquared) {
  EXPECT_NEAR(chi_squared_probability_above(25.0, 2.0) / 3.7266531720786718e-06, 1.0, 1e-12);
  EXPECT_NEAR(chi_squared_probability_above(60.0, 6.0) / 4.501016648012131e-11, 1.0, 1e-12);
  EXPECT_EQ(chi_squared_probability_above(0.0, 3.0), 1.0);
}

TEST(Statistics, NormalQuantiles) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-12);
  EXPECT_NEAR(normal_quantile(0.5), 0.0, 1e-15);
  EXPECT_NEAR(sigma_per_median(), 1.482602218505602, 1e-12);
}

// JCGM 100, H.1.6: the end gauge's components of 25 (18), 9.7 (25.6), 2.9 (50) and 16.6 nm (2) have 16.7 together.
TEST(Statistics, EffectiveDegreesOfFreedomOfTheGuide) {
  const std::array<UncertaintyComponent, 4> components{{{25.0, 18}, {9.7, 25.6}, {2.9, 50}, {16.6, 2}}};
  EXPECT_NEAR(effective_degrees_of_freedom(components), 16.7, 0.1);
}

TEST(Statistics, EffectiveDegreesOfFreedomOfOneComponentAreItsOwn) {
  EXPECT_NEAR(effective_degrees_of_freedom(std::array<UncertaintyComponent, 2>{{{1e-9, 3}, {0.0, 1}}}), 3.0, 1e-12);
  EXPECT_TRUE(std::isinf(effective_degrees_of_freedom(std::array<UncertaintyComponent, 2>{{{0.0, 3}, {1.0}}})));
  EXPECT_TRUE(std::isinf(effective_degrees_of_freedom({})));
}

}  // namespace
}  // namespace artcal
