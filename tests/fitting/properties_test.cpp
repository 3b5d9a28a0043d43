// What every feature owes: one suite, instantiated for each.
#include <numeric>

#include <gtest/gtest.h>

#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

template <typename F>
class FeatureProperties : public testing::Test {
 protected:
  static constexpr double noise = 0.01;
  Eigen::Matrix3Xd points = Shape<F>::points(60, noise);
  static Fitted<F> fitted(const Eigen::Matrix3Xd& p, const FitOptions& options = {}) {
    auto result = fit<F>(p, options);
    EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().text());
    EXPECT_EQ(result->status, FitStatus::Converged);
    return *result;
  }
  static void expect_same(const F& a, const F& b, double length, double angle) {
    const Apart difference = apart(a, b);
    EXPECT_LT(difference.length, length) << difference;
    EXPECT_LT(difference.angle, angle) << difference;
  }
};

using Features = testing::Types<Sphere, Plane, Line, Circle, Cylinder, Cone>;
TYPED_TEST_SUITE(FeatureProperties, Features);

TYPED_TEST(FeatureProperties, ExactPointsGiveTheTruth) {
  const auto fitted = this->fitted(Shape<TypeParam>::points(60, 0.0));
  this->expect_same(fitted.feature, Shape<TypeParam>::truth(), 1e-12, 1e-13);
  EXPECT_LT(fitted.form, 1e-12);
}

TYPED_TEST(FeatureProperties, NoiseMovesItByAboutItself) {
  const auto fitted = this->fitted(this->points);
  this->expect_same(fitted.feature, Shape<TypeParam>::truth(), this->noise, this->noise / 10.0);
  EXPECT_NEAR(fitted.noise.value(), this->noise, 0.3 * this->noise);
}

TYPED_TEST(FeatureProperties, ARigidMotionMovesTheAnswer) {
  const auto still = this->fitted(this->points);
  const auto after = this->fitted(moved(a_motion(), this->points));
  this->expect_same(after.feature, moved(a_motion(), still.feature), 2e-12, 1e-13);
  EXPECT_NEAR(after.form, still.form, 2e-12);
}

TYPED_TEST(FeatureProperties, TheCovarianceTurnsWithTheFrame) {
  const auto still = this->fitted(this->points);
  const auto after = this->fitted(moved(a_motion(), this->points));
  constexpr int n = TypeParam::parameter_count;
  Eigen::Matrix<double, n, n> turn = Eigen::Matrix<double, n, n>::Identity();
  turn.template topLeftCorner<3, 3>() = a_motion().rotation;
  if constexpr (n >= 6) {
    const Eigen::Vector3d turned = a_motion().rotation * still.feature.parameters().template segment<3>(3);
    const double sense = turned.dot(after.feature.parameters().template segment<3>(3)) < 0.0 ? -1.0 : 1.0;
    turn.template block<3, 3>(3, 3) = sense * a_motion().rotation;
  }
  const Eigen::MatrixXd expected = turn * *still.covariance * turn.transpose();
  EXPECT_LT((*after.covariance - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff());
}

TYPED_TEST(FeatureProperties, APermutationDoesNot) {
  Eigen::Matrix3Xd shuffled(3, this->points.cols());
  for (Eigen::Index i = 0; i < this->points.cols(); ++i) {
    shuffled.col(i) = this->points.col((i * 37 + 11) % this->points.cols());
  }
  this->expect_same(this->fitted(shuffled).feature, this->fitted(this->points).feature, 1e-12, 1e-13);
}

TYPED_TEST(FeatureProperties, AScaleScalesIt) {
  for (const double scale : {1e-3, 0.125, 1000.0}) {
    const auto once = this->fitted(this->points);
    const auto scaled_up = this->fitted(scale * this->points);
    this->expect_same(scaled_up.feature, scaled(scale, once.feature), 1e-12 * std::max(1.0, scale), 1e-13);
    EXPECT_NEAR(scaled_up.form, scale * once.form, 1e-12 * std::max(1.0, scale));
  }
}

TYPED_TEST(FeatureProperties, AnOffsetOfTenMetresCostsNoDigit) {
  // Coordinates on a grid of 2⁻²⁰ mm, so that the offset itself is exact.
  const Eigen::Matrix3Xd grid = (this->points * 0x1.0p20).array().round().matrix() * 0x1.0p-20;
  const Eigen::Vector3d offset{10'000.0, -10'000.0, 10'000.0};
  const auto near = this->fitted(grid);
  const auto far = this->fitted(grid.colwise() + offset);
  this->expect_same(far.feature, moved(Rigid{Eigen::Matrix3d::Identity(), offset}, near.feature), 4e-12, 1e-14);
}

TYPED_TEST(FeatureProperties, AWeightOfTwoIsThePointTwice) {
  const Eigen::Index n = this->points.cols();
  Eigen::Matrix3Xd doubled(3, n + 5);
  doubled << this->points, this->points.leftCols(5);
  FitOptions options;
  options.weights = Eigen::VectorXd::Ones(n);
  options.weights.head(5).setConstant(2.0);
  const auto weighted = this->fitted(this->points, options);
  this->expect_same(weighted.feature, this->fitted(doubled).feature, 1e-12, 1e-13);
}

TYPED_TEST(FeatureProperties, AWeightOfZeroLeavesThePointOut) {
  Eigen::Matrix3Xd with_stray = this->points;
  with_stray.col(3) += Eigen::Vector3d(5.0, 6.0, 7.0);
  FitOptions options;
  options.weights = Eigen::VectorXd::Constant(this->points.cols(), 4.0);
  options.weights(3) = 0.0;
  Eigen::Matrix3Xd without(3, this->points.cols() - 1);
  without << this->points.leftCols(3), this->points.rightCols(this->points.cols() - 4);
  const auto weighted = this->fitted(with_stray, options);
  const auto plain = this->fitted(without);
  this->expect_same(weighted.feature, plain.feature, 1e-12, 1e-13);
  EXPECT_EQ(weighted.degrees_of_freedom, plain.degrees_of_freedom);
  EXPECT_NEAR(weighted.form, plain.form, 1e-12);
  EXPECT_GT(std::abs(weighted.residuals(3)), 10.0 * this->noise);
}

TYPED_TEST(FeatureProperties, GivenNoiseScalesTheCovariance) {
  FitOptions options;
  options.noise = 0.04;
  const auto given = this->fitted(this->points, options);
  const auto estimated = this->fitted(this->points);
  const double ratio = given.covariance->trace() / estimated.covariance->trace();
  EXPECT_NEAR(std::sqrt(ratio), 0.04 / *estimated.noise, 0.2 * std::sqrt(ratio));
  EXPECT_EQ(given.noise, 0.04);
}

TYPED_TEST(FeatureProperties, ExactlyDeterminedSetsPassThroughTheirPoints) {
  const auto fitted = this->fitted(Shape<TypeParam>::points(Shape<TypeParam>::fewest, 0.0, 3));
  EXPECT_LT(fitted.residuals.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(fitted.degrees_of_freedom, 0);
  EXPECT_FALSE(fitted.covariance.has_value());
}

TYPED_TEST(FeatureProperties, BadPointsAreRefused) {
  const auto code = [](const Eigen::Matrix3Xd& p, const FitOptions& options = {}) {
    return fit<TypeParam>(p, options).error().code;
  };
  EXPECT_EQ(code(Eigen::Matrix3Xd(3, 0)), ErrorCode::BadInput);
  EXPECT_EQ(code(this->points.leftCols(Shape<TypeParam>::fewest - 1)), ErrorCode::BadInput);
  EXPECT_EQ(code(Eigen::Vector3d(1e4, 2.0, 3.1).replicate(1, 12)), ErrorCode::BadInput);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Eigen::Matrix3Xd spoilt = this->points;
    spoilt(1, 17) = bad;
    const auto error = fit<TypeParam>(spoilt).error();
    EXPECT_EQ(error.code, ErrorCode::BadInput);
    EXPECT_NE(error.message.find("17"), std::string::npos) << error.message;
  }
}

TYPED_TEST(FeatureProperties, BadWeightsAreRefused) {
  FitOptions options;
  options.weights = Eigen::VectorXd::Ones(3);
  EXPECT_EQ(fit<TypeParam>(this->points, options).error().code, ErrorCode::BadInput);
  options.weights = Eigen::VectorXd::Ones(this->points.cols());
  options.weights(2) = -1.0;
  EXPECT_EQ(fit<TypeParam>(this->points, options).error().code, ErrorCode::BadInput);
  options.weights.setZero();
  EXPECT_EQ(fit<TypeParam>(this->points, options).error().code, ErrorCode::BadInput);
}

}  // namespace
}  // namespace artcal::test
