// Where a residual counts as outlying: the limits are scipy's, the sizes those of a χ².
#include "identification/evaluation/outliers.h"

#include <cmath>

#include <gtest/gtest.h>

namespace artcal {
namespace {

// sqrt(scipy.stats.chi2.isf(0.05 / count, freedom)), scipy 1.10.
TEST(Outliers, LimitsAreThoseOfChiSquared) {
  EXPECT_NEAR(outlier_limit(100, {1.0, 3.0, 0.0, 0.0}), 4.210700206491, 1e-9);
  EXPECT_NEAR(outlier_limit(100, {1.0, 1.0, 0.0, 0.0}), 3.480756404346, 1e-9);
  EXPECT_NEAR(outlier_limit(2000, {1.0, 2.4, 0.0, 0.0}), 4.728952443791, 1e-9);
}

// Three residuals of one standard deviation each, which the fit leaves half of their variance: s = 6 of three degrees
// of freedom. One that the fit adapts to says nothing, however it lies.
TEST(Outliers, SizesAreInWhatTheFitLeaves) {
  EXPECT_NEAR(standardised(3.0, 3, {0.5, 3.0, 0.5, 0.0}), std::sqrt(6.0), 1e-15);
  EXPECT_NEAR(standardised(3.0, 3, {0.5, 2.0, 0.5, 0.0}), 2.0, 1e-15);
  EXPECT_EQ(standardised(9.0, 1, {0.0, 1.0, 1.0, 0.0}), 0.0);
}

// Readings, distances that bind and certified numbers are what can be outlying; a distance between certified centres
// says nothing that these do not.
TEST(Outliers, CountsWhatCanBeOne) {
  Constraints constraints;
  constraints.features.resize(2);
  constraints.features[0].readings = {0, 1, 2};
  constraints.features[1].readings = {3, 4};
  constraints.distances = {{0, 1, 500.0, 1e-3, true}, {0, 1, 500.0, 1e-3, false}};
  constraints.shared.resize(2);
  constraints.shared[0].u = 1e-4;
  EXPECT_EQ(observation_count(constraints), 5 + 1 + 1);
}

TEST(Outliers, TheWarningNamesTheWorstAndTheirNumber) {
  EXPECT_TRUE(warning_of({}, Loss::None).empty());
  CertificateOutlier outlier;
  outlier.name = {"bar", "p1", "A"};
  outlier.second = "B";
  outlier.certified = 500.0;
  outlier.u = 1e-3;
  outlier.deviation = -0.2;
  outlier.standardised = 40.0;
  const std::string text = warning_of({outlier, outlier}, Loss::None);
  EXPECT_NE(text.find("distance \"A\" to \"B\" 500 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("+0.2 mm off"), std::string::npos) << text;
  EXPECT_NE(text.find("(and 1 more"), std::string::npos) << text;
}

}  // namespace
}  // namespace artcal
