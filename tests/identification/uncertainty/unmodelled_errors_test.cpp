#include "identification/uncertainty/unmodelled_errors.h"

#include <cmath>

#include <gmock/gmock.h>

namespace artcal {
namespace {

// `count` placements, each with predictions that are off by `ratio` times the arm's u of 1 µm.
std::vector<LeftOut> placements(int count, double ratio, int predictions = 1) {
  std::vector<LeftOut> all(static_cast<std::size_t>(count));
  for (LeftOut& left : all) {
    left.predictions.assign(static_cast<std::size_t>(predictions), {1e-3 * ratio, 1e-3, 0.0});
  }
  return all;
}

// By scipy 1.10: chi2.isf(0.01, 4) = 13.2767, t.isf(0.025, 4) = 2.776445, norm.isf(0.025) = 1.959964.
TEST(UnmodelledErrors, EnlargeToWhatPlacementsShow) {
  const CrossValidation found = cross_validate(placements(4, 3.0), false, Loss::None);
  EXPECT_EQ(found.placements, 4);
  EXPECT_NEAR(found.ratio, 3.0, 1e-12);
  EXPECT_NEAR(found.limit, std::sqrt(13.2767 / 4.0), 1e-5);
  EXPECT_NEAR(found.scale, 3.0 * 2.776445 / 1.959964, 1e-5);
}

TEST(UnmodelledErrors, WhatChanceExplainsChangesNothing) {
  EXPECT_EQ(cross_validate(placements(4, 1.8), false, Loss::None).scale, 1.0);
  EXPECT_GT(cross_validate(placements(4, 1.85), false, Loss::None).scale, 1.0);
  // Ten lengths of one placement are one placement: they hang together.
  EXPECT_EQ(cross_validate(placements(4, 1.8, 10), false, Loss::None).scale, 1.0);
  // Where the residuals have shown an effect already, nothing is left to chance.
  EXPECT_GT(cross_validate(placements(4, 1.2), true, Loss::None).scale, 1.2);
  EXPECT_EQ(cross_validate(placements(4, 0.9), true, Loss::None).scale, 1.0);
}

// A bar whose certificate is off by 1.9 standard uncertainties is so in each placement: it is one error, and chance
// allows 2.576 of it (scipy 1.10: norm.isf(0.005)), not the 1.82 of four independent ones.
TEST(UnmodelledErrors, OneCertificateIsOneErrorInAllPlacements) {
  auto all = placements(4, 1.9);
  for (LeftOut& left : all) left.predictions[0] = {1.9e-3, 0.0, 1e-3, 1e-3, {0, 0, 1}};
  const CrossValidation found = cross_validate(all, false, Loss::None);
  EXPECT_NEAR(found.effective_placements, 1.0, 1e-12);
  EXPECT_NEAR(found.limit, 2.575829, 1e-6);
  EXPECT_EQ(found.scale, 1.0);
  // Half of the variance: 4²/(4 + 12·(1/2)²).
  for (LeftOut& left : all) left.predictions[0] = {1.9e-3, 1e-3, 1e-3, 1e-3, {0, 0, 1}};
  EXPECT_NEAR(cross_validate(all, false, Loss::None).effective_placements, 16.0 / 7.0, 1e-12);
  // A bar of its own in each.
  for (std::size_t p = 0; p < all.size(); ++p) all[p].predictions[0].certified[0] = static_cast<int>(p);
  EXPECT_NEAR(cross_validate(all, false, Loss::None).effective_placements, 4.0, 1e-12);
}

TEST(UnmodelledErrors, NothingLeftOutShowsNothing) {
  const CrossValidation found = cross_validate({LeftOut{}, LeftOut{}}, true, Loss::None);
  EXPECT_EQ(found.placements, 0);
  EXPECT_EQ(found.scale, 1.0);
}

// 5 µm where the arm allows 1 and the readings 3: 25 = s²·1 + 9, s = 4.
TEST(UnmodelledErrors, WhatTheReadingsBringIsNotTheArms) {
  auto all = placements(4, 5.0);
  for (LeftOut& left : all) left.predictions[0].u_other = 3e-3;
  EXPECT_NEAR(cross_validate(all, true, Loss::None).scale, 4.0 * 2.776445 / 1.959964, 1e-5);
}

// One placement that a robust loss let go of does not speak for the others.
TEST(UnmodelledErrors, ARobustLossAsksTheMedian) {
  auto all = placements(5, 0.6);
  all[2].predictions[0].error = 1.0;
  EXPECT_GT(cross_validate(all, false, Loss::None).scale, 100.0);
  EXPECT_EQ(cross_validate(all, false, Loss::Cauchy).scale, 1.0);
}

TEST(UnmodelledErrors, AreInTheCovarianceAndNamed) {
  Identification result;
  result.covariance = Eigen::Matrix2d::Identity();
  result.parameters.resize(2);
  result.parameters[0].u = result.parameters[1].u = 1.0;
  CrossValidation found;
  found.placements = 4;
  found.ratio = 2.5;
  found.scale = 3.0;
  enlarge_for_unmodelled_errors(found, result);
  EXPECT_NEAR(result.covariance(1, 1), 9.0, 1e-12);
  EXPECT_NEAR(result.parameters[1].u, 3.0, 1e-12);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_THAT(result.warnings[0], ::testing::HasSubstr("unmodelled error: in 4 placements left out"));
  EXPECT_THAT(result.warnings[0], ::testing::HasSubstr("enlarged by 3.00"));
}

}  // namespace
}  // namespace artcal
