// Of many points: what several threads compute, one computes to the last digit; and that it is the least-squares
// feature is shown by a plain Gauss-Newton in long double.

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "fitting/robust/robust.h"
#include "tests/fitting/shapes.h"

namespace artcal {
namespace {

constexpr int many = 300'000;

template <typename F>
Eigen::Matrix3Xd many_points(double share_of_outliers) {
  Eigen::Matrix3Xd points = test::Shape<F>::points(many, 0.01);
  RandomStream random(8, "outliers");
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (random.uniform() < share_of_outliers) {
      points.col(i) += normal_vector(random);
    }
  }
  return points;
}

template <typename F>
void expect_same(const Fitted<F>& a, const Fitted<F>& b) {
  EXPECT_EQ(a.feature.parameters(), b.feature.parameters());
  EXPECT_EQ(a.residuals, b.residuals);
  EXPECT_EQ(a.form, b.form);
  EXPECT_EQ(a.rms, b.rms);
  EXPECT_EQ(a.noise, b.noise);
  EXPECT_EQ(a.covariance, b.covariance);
  EXPECT_EQ(a.degrees_of_freedom, b.degrees_of_freedom);
}

// Inside of other work there is one thread; on a machine of one processor the comparison is with itself.
template <typename Work>
auto on_one_thread(const Work& work) {
  const OneThreadOnly one;
  return work();
}

template <typename F>
class ManyPoints : public ::testing::Test {};
using Features = ::testing::Types<Sphere, Plane, Line, Circle, Cylinder, Cone>;
TYPED_TEST_SUITE(ManyPoints, Features);

TYPED_TEST(ManyPoints, OneThreadGivesTheDigitsOfSeveral) {
  const auto points = many_points<TypeParam>(0.0);
  const auto plain = [&] { return fit<TypeParam>(points); };
  expect_same(plain().value(), on_one_thread(plain).value());
  const auto with_outliers = many_points<TypeParam>(0.01);
  const auto robust = [&] { return fit_robust<TypeParam>(with_outliers); };
  const auto several = robust();
  const auto one = on_one_thread(robust);
  ASSERT_TRUE(several && one);
  expect_same(several->fitted, one->fitted);
  EXPECT_EQ(several->outliers, one->outliers);
  EXPECT_GT(several->outliers.size(), many / 200u);
}

// Weights of zero and one choose: the feature is that of the points chosen, the residuals are those of all.
TYPED_TEST(ManyPoints, WeightsOfZeroAndOneChoose) {
  const auto points = many_points<TypeParam>(0.3);
  FitOptions options;
  options.weights.resize(many);
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < many; ++i) {
    const bool near = std::abs(signed_distance(test::Shape<TypeParam>::truth(), points.col(i))) < 0.04;
    options.weights(i) = near ? 1.0 : 0.0;
    if (near) chosen.push_back(i);
  }
  const auto weighted = fit<TypeParam>(points, options).value();
  // The same weights as the general way takes them.
  options.weights *= 4.0;
  const auto general = fit<TypeParam>(points, options).value();
  const auto apart = test::apart(weighted.feature, general.feature);
  EXPECT_LT(apart.length, 1e-11);
  EXPECT_LT(apart.angle, 1e-12);
  EXPECT_LT((weighted.residuals - general.residuals).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_NEAR(weighted.form, general.form, 1e-10);
  EXPECT_NEAR(weighted.rms, general.rms, 1e-12);
  EXPECT_NEAR(2.0 * *weighted.noise, *general.noise, 1e-12);
  EXPECT_EQ(weighted.degrees_of_freedom, general.degrees_of_freedom);
  EXPECT_EQ(weighted.degrees_of_freedom, fit<TypeParam>(points(Eigen::all, chosen))->degrees_of_freedom);
}

using Long = long double;
using LongVector = Eigen::Matrix<Long, 4, 1>;

Sphere by_gauss_newton(const Eigen::Matrix3Xd& points, Sphere start) {
  LongVector x;
  x << start.centre.cast<Long>(), start.radius;
  for (int step = 0; step < 20; ++step) {
    Eigen::Matrix<Long, 4, 4> normal = Eigen::Matrix<Long, 4, 4>::Zero();
    LongVector pull = LongVector::Zero();
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Eigen::Matrix<Long, 3, 1> way = points.col(i).cast<Long>() - x.head<3>();
      const Long length = way.norm();
      LongVector row;
      row << way / length, 1.0L;
      normal += row * row.transpose();
      pull += (length - x(3)) * row;
    }
    const LongVector move = normal.ldlt().solve(pull);
    x += move;
    if (move.norm() < 1e-15L) break;
  }
  return {x.head<3>().cast<double>(), static_cast<double>(x(3))};
}

TEST(ManyPointsOfASphere, AreFittedAsByLongDoubles) {
  auto points = many_points<Sphere>(0.0);
  points.colwise() += Eigen::Vector3d(300.0, 200.0, 1000.0);
  const Sphere fitted = fit<Sphere>(points)->feature;
  EXPECT_LT(test::apart(fitted, by_gauss_newton(points, fitted)).length, 1e-11);
}

TEST(ManyPointsOfASphere, RobustFitIsThatOfThePointsKept) {
  const auto points = many_points<Sphere>(0.01);
  const auto robust = fit_robust<Sphere>(points).value();
  std::vector<Eigen::Index> kept;
  auto next = robust.outliers.begin();
  for (Eigen::Index i = 0; i < many; ++i) {
    if (next != robust.outliers.end() && *next == i) {
      ++next;
    } else {
      kept.push_back(i);
    }
  }
  const Sphere reference = by_gauss_newton(points(Eigen::all, kept), robust.fitted.feature);
  EXPECT_LT(test::apart(robust.fitted.feature, reference).length, 1e-11);
  // The list is what four standard deviations about that sphere leave out, but for what lies on the border.
  int differ = 0;
  const double noise = *robust.fitted.noise;
  std::vector<bool> is_outlier(many, false);
  for (const int i : robust.outliers) is_outlier[static_cast<std::size_t>(i)] = true;
  for (Eigen::Index i = 0; i < many; ++i) {
    const double off = std::abs((points.col(i) - reference.centre).norm() - reference.radius) / noise;
    differ += is_outlier[static_cast<std::size_t>(i)] != (off > 4.0) && std::abs(off - 4.0) > 0.01 ? 1 : 0;
  }
  EXPECT_EQ(differ, 0);
}

}  // namespace
}  // namespace artcal
