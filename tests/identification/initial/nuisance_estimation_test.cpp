// Planted points, balls and radii, from tips that are given: no arm takes part.
#include "identification/initial/nuisance_estimation.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace artcal {
namespace {

constexpr double tip_radius = 3.0;

Eigen::Matrix3Xd touches(const Eigen::Vector3d& centre, double distance, int count, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  Eigen::Matrix3Xd points(3, count);
  for (int k = 0; k < count; ++k) {
    points.col(k) = centre + distance * Eigen::Vector3d{normal(engine), normal(engine), normal(engine)}.normalized();
  }
  return points;
}

/// Two features of one artefact in one placement, whose centres are unknown.
struct Two {
  Recording recording;
  Constraints constraints;
  System system;
  std::vector<Tips> tips;

  Two(ConstraintKind of_first, ConstraintKind of_second) {
    recording.placements.index_of("p1");
    constraints.artefacts.resize(1);
    constraints.artefacts[0].name = "bar";
    constraints.artefacts[0].features.resize(2);
    constraints.artefacts[0].features[0].name = "A";
    constraints.artefacts[0].features[1].name = "B";
    constraints.features.resize(2);
    constraints.groups = {{false, false, 6}};
    for (int f = 0; f < 2; ++f) {
      FeatureConstraint& feature = constraints.features[f];
      feature.kind = f == 0 ? of_first : of_second;
      feature.feature = f;
      feature.group = 0;
      feature.offset = 3 * f;
    }
    system.constraints = &constraints;
  }

  void read(int f, const Eigen::Matrix3Xd& centres) {
    constraints.features[f].readings.resize(static_cast<std::size_t>(centres.cols()));
    tips.push_back({&constraints.features[f], centres, Eigen::VectorXd::Constant(centres.cols(), tip_radius), {}});
  }
  Expected<Unknowns> estimate() { return estimate_nuisance_parameters(system, {}, recording, tips); }
};

const Eigen::Vector3d first(300.0, -200.0, 150.0), second(700.0, 100.0, 400.0);

TEST(NuisanceEstimation, APointIsTheMeanOfItsTips) {
  Two two(Coincide{}, Coincide{});
  Eigen::Matrix3Xd around(3, 2);
  around << 1, -1, 2, -2, 0, 0;
  two.read(0, around.colwise() + first);
  two.read(1, around.colwise() + second);
  const auto found = two.estimate();
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_LT((found->groups[0].values.head<3>() - first).norm(), 1e-12);
  EXPECT_LT((found->groups[0].values.tail<3>() - second).norm(), 1e-12);
}

TEST(NuisanceEstimation, ABallOfKnownRadiusHasItsCentre) {
  Two two(OnBall{12.7}, OnBall{19.05});
  two.read(0, touches(first, 12.7 + tip_radius, 6, 1));
  two.read(1, touches(second, 19.05 + tip_radius, 6, 2));
  const auto found = two.estimate();
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_LT((found->groups[0].values.head<3>() - first).norm(), 1e-9);
  EXPECT_LT((found->groups[0].values.tail<3>() - second).norm(), 1e-9);
}

TEST(NuisanceEstimation, TooFewTouchesAreRefusedByName) {
  Two two(OnBall{12.7}, OnBall{12.7});
  two.read(0, touches(first, 12.7 + tip_radius, 6, 1));
  Eigen::Matrix3Xd three = touches(second, 12.7 + tip_radius, 3, 2);
  two.read(1, three);
  const auto found = two.estimate();
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::NoSolution);
  EXPECT_THAT(found.error().text(), testing::AllOf(testing::HasSubstr("\"B\""), testing::HasSubstr("3 readings")));
}

// Centres 500.3 mm apart move along their line, by 0.15 mm each, to the certified 500 mm.
TEST(NuisanceEstimation, CertifiedDistancesAreMetByTheLeastShift) {
  Two two(OnBall{}, OnBall{});
  two.constraints.distances = {{0, 1, 500.0, 1e-3, true}};
  Unknowns unknowns;
  unknowns.groups.resize(1);
  unknowns.groups[0].values.resize(6);
  unknowns.groups[0].values << 10.0, 20.0, 30.0, 510.3, 20.0, 30.0;
  satisfy_distances(two.constraints, unknowns);
  const Eigen::VectorXd expected = (Eigen::VectorXd(6) << 10.15, 20.0, 30.0, 510.15, 20.0, 30.0).finished();
  EXPECT_LT((unknowns.groups[0].values - expected).norm(), 1e-10);
}

}  // namespace
}  // namespace artcal
