// Counts of trials against the sorted values themselves.
#include "identification/monte_carlo/distribution.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

std::vector<double> normal_values(int count) {
  RandomStream random(3, "values");
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(100.0 + 0.02 * random.normal());
  return values;
}

Distribution counted(const std::vector<double>& values, const Ruler& ruler) {
  Distribution distribution(ruler);
  for (const double value : values) distribution.add(value);
  return distribution;
}

double sorted_quantile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(p * static_cast<double>(values.size()))];
}

bool same(const Distribution& a, const Distribution& b) {
  const auto x = a.contents();
  const auto y = b.contents();
  return x.count == y.count && x.below == y.below && x.above == y.above && x.sum == y.sum && x.squares == y.squares &&
         x.counts == y.counts;
}

TEST(Distribution, HasTheMomentsAndQuantilesOfTheValues) {
  const auto values = normal_values(20'000);
  const double n = 20'000.0;
  double mean = 0.0;
  for (const double value : values) mean += value / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const Distribution distribution = counted(values, {99.99, 0.018});  // a ruler that is a little off
  EXPECT_NEAR(distribution.mean(), mean, 1e-9);
  EXPECT_NEAR(distribution.deviation(), std::sqrt(squares / (n - 1.0)), 1e-9);
  for (const double p : {0.025, 0.5, 0.84, 0.975}) {
    EXPECT_NEAR(*distribution.quantile(p), sorted_quantile(values, p), 0.018 / 256.0);
  }
}

TEST(Distribution, DoesNotDependOnOrderOrShares) {
  auto values = normal_values(3'000);
  const Ruler ruler{100.0, 0.02};
  const Distribution whole = counted(values, ruler);
  std::reverse(values.begin(), values.end());
  EXPECT_TRUE(same(whole, counted(values, ruler)));
  Distribution parts = counted({values.begin(), values.begin() + 17}, ruler);
  parts.add(counted({values.begin() + 17, values.end()}, ruler));
  EXPECT_TRUE(same(whole, parts));
  EXPECT_TRUE(same(whole, Distribution(whole.contents())));
}

TEST(Distribution, ShortestIntervalOfASkewedOneBeginsAtItsPeak) {
  // Exponential: the shortest 95 % are [0, −ln 0.05], the symmetric ones [−ln 0.975, −ln 0.025].
  RandomStream random(5, "exponential");
  Distribution distribution(Ruler{1.0, 1.0});
  for (int i = 0; i < 200'000; ++i) distribution.add(-std::log(1.0 - random.uniform()));
  const auto shortest = distribution.shortest(0.95);
  ASSERT_TRUE(shortest);
  EXPECT_NEAR(shortest->low, 0.0, 0.02);
  EXPECT_NEAR(shortest->high, 2.9957, 0.04);
  const auto symmetric = distribution.symmetric(0.95);
  EXPECT_NEAR(symmetric->low, 0.02532, 0.005);
  EXPECT_NEAR(symmetric->high, 3.6889, 0.05);
}

TEST(Distribution, SaysHowWellItsNumbersStand) {
  // Of n normal values: mean 1/√n, deviation 1/√(2n), the 97.5 % quantile √(p(1−p)/n)/φ(1.96).
  RandomStream random(6, "normal");
  Distribution distribution(Ruler{0.0, 1.0});
  for (int i = 0; i < 400'000; ++i) distribution.add(random.normal());
  EXPECT_NEAR(distribution.error_of_mean(), 0.001581, 3e-5);
  EXPECT_NEAR(distribution.error_of_deviation(), 0.001118, 3e-5);
  EXPECT_NEAR(*distribution.error_of_quantile(0.975), 0.004224, 6e-4);
}

TEST(Distribution, HasNoQuantileBeyondItsCells) {
  Distribution distribution(Ruler{0.0, 1.0});
  for (int i = 0; i < 10; ++i) distribution.add(i < 5 ? 0.0 : 1e9);
  EXPECT_TRUE(distribution.quantile(0.4));
  EXPECT_FALSE(distribution.quantile(0.9));
  EXPECT_FALSE(distribution.symmetric(0.95));
  EXPECT_FALSE(distribution.shortest(0.95));
  EXPECT_FALSE(Distribution(Ruler{0.0, 1.0}).quantile(0.5));
}

TEST(Distribution, OfOneValueIsNarrow) {
  Distribution distribution(Ruler{7.0, 1e-12});
  for (int i = 0; i < 100; ++i) distribution.add(7.0);
  EXPECT_EQ(distribution.deviation(), 0.0);
  EXPECT_NEAR(distribution.shortest(0.95)->high, 7.0, 1e-12);
}

}  // namespace
}  // namespace artcal
