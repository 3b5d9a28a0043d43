#include "identification/residual.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

struct Case {
  Location location;
  Demand demand;
};

class ResidualDerivatives : public ::testing::TestWithParam<Case> {};

// Every kind of residual against central differences, by the tip and by its unknowns.
TEST_P(ResidualDerivatives, AreTheDifferences) {
  RandomStream random(3, "residual");
  for (int trial = 0; trial < 50; ++trial) {
    FeatureConstraint constraint;
    constraint.location = GetParam().location;
    constraint.demand = GetParam().demand;
    constraint.readings = {0};
    constraint.known = {100.0 * random.direction()};
    constraint.distances = {40.0};
    constraint.offset = constraint.location == Location::Unknown ? 3 : 0;
    const Eigen::Matrix3d reference = random.rotation();
    Eigen::VectorXd values(6);
    for (double& v : values) v = random.uniform(-1.0, 1.0);
    values.tail<3>() *= 200.0;
    const Eigen::Vector3d tip = 300.0 * random.direction();
    const auto at = [&](const Eigen::VectorXd& unknowns, const Eigen::Vector3d& point) {
      return FeatureResidual(constraint, reference, unknowns.data()).at(0, point, false);
    };
    const FeatureResidual residual(constraint, reference, values.data());
    const Residual r = residual.at(0, tip, true);
    ASSERT_EQ(r.rows, GetParam().demand == Demand::Coincide ? 3 : 1);
    constexpr double h = 1e-5;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
      const Eigen::VectorXd slope =
          (at(values, tip + step).value.head(r.rows) - at(values, tip - step).value.head(r.rows)) / (2.0 * h);
      EXPECT_LT((slope - r.by_tip.col(i).head(r.rows)).norm(), 1e-7);
    }
    for (int i = 0; i < residual.columns(); ++i) {
      Eigen::VectorXd step = Eigen::VectorXd::Zero(6);
      step[residual.first_column() + i] = h;
      const Eigen::VectorXd slope =
          (at(values + step, tip).value.head(r.rows) - at(values - step, tip).value.head(r.rows)) / (2.0 * h);
      EXPECT_LT((slope - r.by_unknowns.col(i).head(r.rows)).norm(), 1e-5 * (1.0 + slope.norm()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ResidualDerivatives,
    ::testing::Values(Case{Location::Unknown, Demand::Coincide}, Case{Location::Unknown, Demand::AtDistance},
                      Case{Location::Posed, Demand::Coincide}, Case{Location::Posed, Demand::AtDistance},
                      Case{Location::Base, Demand::Coincide}, Case{Location::Base, Demand::AtDistance}));

// Signed: inside the ball is negative, outside positive, no jump between.
TEST(Residual, OfABallIsSigned) {
  FeatureConstraint ball;
  ball.location = Location::Base;
  ball.demand = Demand::AtDistance;
  ball.readings = {0};
  ball.known = {Eigen::Vector3d::Zero()};
  ball.distances = {10.0};
  const FeatureResidual residual(ball, Eigen::Matrix3d::Identity(), nullptr);
  EXPECT_DOUBLE_EQ(residual.at(0, {9.0, 0.0, 0.0}, false).value[0], -1.0);
  EXPECT_DOUBLE_EQ(residual.at(0, {0.0, 12.0, 0.0}, false).value[0], 2.0);
}

// Moving base and artefact together moves nothing in a posed residual, even one far from zero.
TEST(Residual, OfAPosedPointDoesNotSeeTheBaseMove) {
  RandomStream random(4, "base");
  FeatureConstraint point;
  point.location = Location::Posed;
  point.readings = {0};
  point.known = {{1.0, 2.0, 3.0}};
  const Rigid moved_from_base{random.rotation(), 500.0 * random.direction()};
  const Rigid pose{random.rotation(), 300.0 * random.direction()};
  const Eigen::Vector3d tip = 400.0 * random.direction();
  const auto at = [&](const Rigid& base_from_artefact, const Eigen::Vector3d& p) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(6);
    values.tail<3>() = base_from_artefact.translation;
    return FeatureResidual(point, base_from_artefact.rotation, values.data()).at(0, p, false).value;
  };
  EXPECT_LT((at(pose, tip) - at(moved_from_base * pose, moved_from_base * tip)).norm(), 1e-11);
}

}  // namespace
}  // namespace artcal
