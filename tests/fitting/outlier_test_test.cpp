#include "fitting/outlier_test.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace artcal::fitting {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The largest distance that chance explains, by halving.
double limit_of(const LeftOutPoints& left_out, double chance) {
  double low = 0.0, high = 1e9;
  while (high - low > 1e-9 * high) {
    const double middle = low > 0.0 ? std::sqrt(low * high) : 1.0;
    (are_outliers(middle, left_out, chance) ? high : low) = middle;
  }
  return high;
}

// scipy 1.10: stats.t.isf(chance/2, nu), stats.norm.isf(chance/2); two dimensions: sqrt(2*stats.f.isf(chance, 2, nu)).
TEST(OutlierTest, OfOnePointItIsStudents) {
  EXPECT_NEAR(limit_of({9, 1, 1, 1}, 6.334248366623973e-05) / 10050.439032475448, 1.0, 1e-5);
  EXPECT_NEAR(limit_of({9, 1, 1, 2}, 6.334248366623973e-05) / 125.64112687430162, 1.0, 1e-5);
  EXPECT_NEAR(limit_of({9, 1, 1, 5}, 6.334248366623973e-05) / 12.281424348286638, 1.0, 1e-5);
  EXPECT_NEAR(limit_of({9, 1, 1, infinite}, 6.334248366623973e-05), 4.0, 1e-6);
  EXPECT_NEAR(limit_of({9, 1, 2, 2}, 6.334248366623973e-05) / 177.68619961788798, 1.0, 1e-5);
  EXPECT_NEAR(limit_of({9, 1, 2, 6}, 6.334248366623973e-05) / 12.021531985737527, 1.0, 1e-5);
}

// Two of three independent normal values of known noise: C(3, 2)·P² ≤ 3·chance asks less than P ≤ chance does.
TEST(OutlierTest, SubsetsCostNothingWhereTheNoiseIsKnown) {
  EXPECT_NEAR(limit_of({3, 2, 1, infinite}, 6.334248366623973e-05), 4.0, 1e-6);
}

// Numerical integration by scipy 1.10 (integrate.quad over chi): the distance d at which
// C(n, k)·mean of (2·norm.sf(d·s))^k is n·chance; for the last two Student's limit of one point is the larger.
TEST(OutlierTest, ManySubsetsOfFewPointsAskForMore) {
  EXPECT_NEAR(limit_of({9, 3, 1, 2}, 6.334248366623973e-05) / 168.5465586357635, 1.0, 1e-5);
  EXPECT_NEAR(limit_of({10, 4, 1, 2}, 6.334248366623973e-05) / 200.0406672626831, 1.0, 1e-5);
  EXPECT_NEAR(limit_of({20, 6, 1, 10}, 6.334248366623973e-05) / 6.567178767950701, 1.0, 1e-5);
  EXPECT_NEAR(limit_of({8, 2, 2, 6}, 6.334248366623973e-05) / 12.021531985737527, 1.0, 1e-5);
}

}  // namespace
}  // namespace artcal::fitting
