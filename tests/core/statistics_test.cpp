#include "core/statistics.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(Statistics, RootMeanSquare) {
  EXPECT_DOUBLE_EQ(root_mean_square(std::array{3.0, -4.0}), 3.5355339059327378);
  EXPECT_EQ(root_mean_square({}), 0.0);
}

TEST(Statistics, MaxAbsSeesNegativeValues) {
  EXPECT_EQ(max_abs(std::array{1.0, -7.0, 3.0}), 7.0);
  EXPECT_EQ(max_abs({}), 0.0);
}

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

TEST(Statistics, ChiSquaredProbabilityIsTheInverse) {
  for (const double freedom : {1.0, 2.0, 7.0, 300.0, 30000.0}) {
    for (const double probability : {0.001, 0.05, 0.5, 0.95, 0.999}) {
      EXPECT_NEAR(chi_squared_probability(chi_squared_quantile(probability, freedom), freedom), probability, 1e-10);
    }
  }
  EXPECT_EQ(chi_squared_probability(0.0, 5.0), 0.0);
  // Two degrees of freedom have a closed form: 1 - exp(-x/2).
  EXPECT_NEAR(chi_squared_probability(2.0, 2.0), 0.63212055882855768, 1e-15);
}

}  // namespace
}  // namespace artcal
