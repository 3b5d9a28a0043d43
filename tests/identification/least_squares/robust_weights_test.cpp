// Weights of the robust fit against planted noise.
#include "identification/least_squares/robust_weights.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace artcal {
namespace {

/// Readings of three coordinates with residuals of `scale` standard deviations, of which `share` lie a hundred times
/// further off, and of which the fit leaves `variance`.
struct Planted {
  WhitenedResiduals residuals;
  Redundancy redundancy;

  Planted(double scale, double share, double variance) {
    std::mt19937_64 engine(20261128);
    std::normal_distribution<double> normal;
    constexpr int count = 4000;
    residuals.readings.resize(1);
    redundancy.readings.resize(1);
    for (int i = 0; i < count; ++i) {
      const double size = scale * std::sqrt(variance) * (i < share * count ? 100.0 : 1.0);
      for (int k = 0; k < 3; ++k) {
        residuals.readings[0].push_back(size * normal(engine));
      }
      redundancy.readings[0].push_back({variance, 3.0, 1.0 - variance, 0.0});
    }
  }
};

// The standard error of a median of 4,000 sizes is 1 %.
TEST(RobustWeights, NoiseIsFoundBesideWrongReadings) {
  const Planted clean(1.7, 0.0, 0.8);
  EXPECT_NEAR(median_noise_factor(clean.residuals, clean.redundancy), 1.7, 0.05);
  const Planted mixed(1.7, 0.1, 0.8);
  // Nine in ten are sound: their quantile 0.5/0.9, which is 1.063 times the median (scipy: chi2(3)).
  EXPECT_NEAR(median_noise_factor(mixed.residuals, mixed.redundancy) / 1.7, 1.0634, 0.03);
}

TEST(RobustWeights, AFitThatAdaptsToAllShowsNoNoise) {
  const Planted adapted(1.7, 0.0, 1e-12);
  EXPECT_EQ(median_noise_factor(adapted.residuals, adapted.redundancy), 1.0);
}

// Least squares counts everything in full; a loss that let go of an observation adds nothing for it.
TEST(RobustWeights, WhatWasLetGoOfAddsNothing) {
  Weights weights;
  weights.features.resize(1);
  weights.features[0].scalar = {2.0, 2.0};
  weights.distances = {5.0};
  LossWeights all{{{1.0, 1.0}}, {1.0}, {}}, some{{{1.0, 0.0}}, {1.0}, {}};
  Redundancy redundancy;
  redundancy.readings = {{Check{}, Check{}}};
  redundancy.distances = {Check{}};
  EXPECT_EQ(counted_weights(weights, Loss::None, all, redundancy).features[0].scalar, (std::vector<double>{2.0, 2.0}));
  const Weights counted = counted_weights(weights, Loss::Cauchy, some, redundancy);
  EXPECT_EQ(counted.features[0].scalar[1], 0.0);
  EXPECT_NEAR(counted.features[0].scalar[0], 2.0 * std::sqrt(moments_of(Loss::Cauchy, 1.0).information), 1e-12);
}

}  // namespace
}  // namespace artcal
