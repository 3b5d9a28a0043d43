#include "identification/least_squares/residual.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

struct Case {
  Location location;
  ConstraintKind (*kind)();
};

template <typename Kind>
ConstraintKind a() {
  return Kind{};
}

template <int facing>
ConstraintKind a_face() {
  return OnPlane{{}, GaugeFace{facing, 70.0}};
}

/// Everything a residual depends on, as one vector: tip (3), tip radius, group (6), shared (4).
using Arguments = Eigen::Matrix<double, 14, 1>;

class ResidualDerivatives : public ::testing::TestWithParam<Case> {};

// Every kind of residual against central differences, by all it depends on.
TEST_P(ResidualDerivatives, AreTheDifferences) {
  RandomStream random(3, "residual");
  for (int trial = 0; trial < 50; ++trial) {
    FeatureConstraint constraint;
    constraint.location = GetParam().location;
    constraint.kind = GetParam().kind();
    constraint.readings = {0};
    constraint.known = {100.0 * random.direction()};
    const Eigen::Vector3d normal = random.direction();
    constraint.expansion = 1.25;
    constraint.offset = constraint.location == Location::Unknown ? 3 : 0;
    if (auto* lengths = constraint.as<AtDistance>()) lengths->distances = {40.0};
    if (auto* ball = constraint.as<OnBall>()) ball->shared_radius = 3;
    if (auto* plane = constraint.as<OnPlane>()) plane->normal = normal;
    if (constraint.location != Location::Unknown || constraint.face() != nullptr) constraint.first_error = 0;
    const GroupReference reference{random.rotation(), 50.0 * random.direction(), 200.0, {1.0, -1.0}};
    Arguments at;
    at.head<3>() = 300.0 * random.direction();
    at[3] = 3.0;
    for (double& v : at.segment<6>(4)) v = random.uniform(-1.0, 1.0);
    at.segment<3>(7) *= 200.0;
    at.tail<4>() = Eigen::Vector4d(1.0, -2.0, 3.0, 12.0);
    const auto residual_at = [&](const Arguments& x) {
      return FeatureResidual(constraint, reference, x.data() + 4, x.data() + 10).at(0, x.head<3>(), x[3], false);
    };
    const FeatureResidual residual(constraint, reference, at.data() + 4, at.data() + 10);
    const Residual r = residual.at(0, at.head<3>(), at[3], true);
    ASSERT_EQ(r.rows, constraint.is<Coincide>() ? 3 : 1);
    Eigen::Matrix<double, 3, 14> slope = Eigen::Matrix<double, 3, 14>::Zero();
    slope.leftCols<3>() = r.by_tip;
    slope(0, 3) = r.by_tip_radius;
    for (int i = 0; i < residual.columns(); ++i) slope.col(4 + residual.column(i)) = r.by_unknowns.col(i);
    if (constraint.first_error) slope.middleCols<3>(10) = r.by_errors;
    if (constraint.shared_radius()) slope(0, 13) = r.by_ball_radius;
    for (int i = 0; i < at.size(); ++i) {
      const Arguments step = 1e-5 * Arguments::Unit(i);
      const Eigen::Vector3d difference = (residual_at(at + step).value - residual_at(at - step).value) / 2e-5;
      EXPECT_LT((difference - slope.col(i)).head(r.rows).norm(), 1e-6 * (1.0 + difference.head(r.rows).norm())) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ResidualDerivatives,
                         ::testing::Values(Case{Location::Unknown, a<Coincide>}, Case{Location::Unknown, a<AtDistance>},
                                           Case{Location::Unknown, a<OnBall>}, Case{Location::Unknown, a<OnPlane>},
                                           Case{Location::Unknown, a_face<1>}, Case{Location::Unknown, a_face<-1>},
                                           Case{Location::Posed, a<Coincide>}, Case{Location::Posed, a<AtDistance>},
                                           Case{Location::Posed, a<OnBall>}, Case{Location::Posed, a<OnPlane>},
                                           Case{Location::Base, a<Coincide>}, Case{Location::Base, a<AtDistance>},
                                           Case{Location::Base, a<OnBall>}, Case{Location::Base, a<OnPlane>}));

// Signed: inside the ball is negative, outside positive, no jump between.
TEST(Residual, OfABallIsSigned) {
  FeatureConstraint ball;
  ball.location = Location::Base;
  ball.kind = OnBall{7.0};
  ball.readings = {0};
  ball.known = {Eigen::Vector3d::Zero()};
  const FeatureResidual residual(ball, {}, nullptr, nullptr);
  EXPECT_DOUBLE_EQ(residual.at(0, {9.0, 0.0, 0.0}, 3.0, false).value[0], -1.0);
  EXPECT_DOUBLE_EQ(residual.at(0, {0.0, 12.0, 0.0}, 3.0, false).value[0], 2.0);
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
    return FeatureResidual(point, {.rotation = base_from_artefact.rotation}, values.data(), nullptr)
        .at(0, p, 0.0, false)
        .value;
  };
  EXPECT_LT((at(pose, tip) - at(moved_from_base * pose, moved_from_base * tip)).norm(), 1e-11);
}

}  // namespace
}  // namespace artcal
