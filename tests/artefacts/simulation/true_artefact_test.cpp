#include "artefacts/simulation/true_artefact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/statistics.h"
#include "tests/support/plans.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

std::string refusal(const PlannedArtefact& planned) {
  const auto real = real_artefact(planned, nullptr);
  return real ? "not refused" : real.error().text();
}

TEST(RealArtefact, LiesOnALineAsItsDistancesSay) {
  PlannedArtefact bar = testing::bar_of(FeatureKind::Sphere);
  bar.certified.distances = {
      {1, 2, 350.0, 4e-4}, {0, 2, 100.0, 4e-4}, {0, 1, 250.0, 4e-4}};  // A between, then C behind
  const auto real = real_artefact(bar, nullptr);
  ASSERT_TRUE(real) << real.error().text();
  EXPECT_NEAR((real->features[0].at - real->features[1].at).norm(), 250.0, 1e-9);
  EXPECT_NEAR((real->features[0].at - real->features[2].at).norm(), 100.0, 1e-9);
  EXPECT_NEAR((real->features[1].at - real->features[2].at).norm(), 350.0, 1e-9);
  EXPECT_EQ(real->features[1].radius, 12.7);
}

TEST(RealArtefact, SmallContradictionsAreSharedOut) {
  PlannedArtefact bar = testing::bar_of(FeatureKind::Point);
  bar.certified.distances[2].value += 0.0006;
  const auto real = real_artefact(bar, nullptr);
  ASSERT_TRUE(real);
  // Three equal weights, one degree of freedom: a third each.
  EXPECT_NEAR((real->features[0].at - real->features[1].at).norm(), 250.0002, 1e-9);
  EXPECT_NEAR((real->features[0].at - real->features[2].at).norm(), 600.0004, 1e-9);
}

TEST(RealArtefact, WhatIsStatedComesFirst) {
  PlannedArtefact bar = testing::bar_of(FeatureKind::Sphere);
  bar.stated[0].at = Eigen::Vector3d(0.0, 250.0, 0.0);
  bar.stated[1].at = Eigen::Vector3d::Zero();
  bar.stated[2].at = Eigen::Vector3d(0.0, -350.0, 0.0);
  bar.stated[1].radius = 12.8;
  const auto real = real_artefact(bar, nullptr);
  ASSERT_TRUE(real) << real.error().text();
  EXPECT_EQ(real->features[2].at, Eigen::Vector3d(0.0, -350.0, 0.0));
  EXPECT_EQ(real->features[1].radius, 12.8);
  bar.stated[2].at->x() = 40.0;
  EXPECT_THAT(refusal(bar),
              HasSubstr("the certified distance between \"B\" and \"C\" of the artefact \"bar\" is 350 mm"));
}

TEST(RealArtefact, ASingleFeatureIsInTheOrigin) {
  PlannedArtefact seat;
  seat.certified.features = {testing::certified("seat", FeatureKind::Point)};
  seat.stated.resize(1);
  EXPECT_EQ(real_artefact(seat, nullptr)->features[0].at, Eigen::Vector3d::Zero());
}

TEST(RealArtefact, SaysWhatNothingPlaces) {
  PlannedArtefact bar = testing::bar_of(FeatureKind::Point);
  bar.certified.distances.pop_back();
  bar.certified.distances.pop_back();
  EXPECT_THAT(refusal(bar), HasSubstr("nothing says where the feature \"C\" of the artefact \"bar\" is beside \"A\""));
  bar = testing::bar_of(FeatureKind::Point);
  bar.certified.distances[2].value = 500.0;
  EXPECT_THAT(refusal(bar), HasSubstr("taken to lie on one line"));
  EXPECT_THAT(refusal(testing::bar_of(FeatureKind::Plane)), HasSubstr("[[true_feature]]"));
  bar = testing::bar_of(FeatureKind::Sphere);
  bar.certified.features[1].radius.reset();
  EXPECT_THAT(refusal(bar), HasSubstr("nobody states the diameter of the ball \"B\""));
}

TEST(RealArtefact, ErrorsHaveTheCertificatesSize) {
  PlannedArtefact plate = testing::bar_of(FeatureKind::Sphere);
  plate.certified.distances.resize(1);
  plate.certified.features[2].at = Eigen::Vector3d(10.0, 20.0, 30.0);
  plate.certified.features[2].u_at = 0.005;
  plate.certified.features[2].u_radius = 0.001;
  plate.certified.u_expansion = 1e-7;
  constexpr int trials = 300;
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();
  for (int i = 0; i < trials; ++i) {
    RandomStream random(1, "test", static_cast<std::uint64_t>(i));
    const auto real = real_artefact(plate, &random);
    sums[0] += std::pow(((real->features[1].at - real->features[0].at).norm() - 250.0) / 4e-4, 2);
    sums[1] += ((real->features[2].at - *plate.certified.features[2].at) / 0.005).squaredNorm();
    sums[2] += std::pow((real->features[2].radius - 12.7) / 0.001, 2);
    sums[3] += std::pow((real->expansion - 11.5e-6) / 1e-7, 2);
  }
  int index = 0;
  for (const double freedom : {1.0, 3.0, 1.0, 1.0}) {
    EXPECT_GT(sums[index], chi_squared_quantile(1e-4, freedom * trials)) << index;
    EXPECT_LT(sums[index], chi_squared_quantile(1.0 - 1e-4, freedom * trials)) << index;
    ++index;
  }
}

}  // namespace
}  // namespace artcal
