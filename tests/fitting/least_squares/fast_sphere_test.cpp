// The plain sphere's short way must give what the general fit gives.
#include "fitting/least_squares/fast_sphere.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

// Weights of one send the same points the long way.
Fitted<Sphere> the_long_way(const Eigen::Matrix3Xd& points) {
  FitOptions options;
  options.weights = Eigen::VectorXd::Ones(points.cols());
  return fit<Sphere>(points, options).value();
}

TEST(FastSphere, AgreesWithTheGeneralFit) {
  for (const int count : {5, 6, 7, 8, 9, 15, 16, 25, 1000, 19'999, 20'000, 50'003, 1'000'003}) {
    SCOPED_TRACE(count);
    const auto points = moved(a_motion(), Shape<Sphere>::points(count, 0.01));
    const auto fast = fitting::fit_plain_sphere(points, {});
    ASSERT_TRUE(fast.has_value());
    const auto slow = the_long_way(points);
    EXPECT_LT(apart(fast->feature, slow.feature).length, 1e-12);
    EXPECT_LT((fast->residuals - slow.residuals).cwiseAbs().maxCoeff(), 2e-12);
    EXPECT_NEAR(fast->form, slow.form, 2e-12);
    EXPECT_NEAR(fast->rms, slow.rms, 1e-12);
    // Its covariance is of the full Hessian, the other's of JᵀJ: they differ by noise / radius.
    EXPECT_LT((*fast->covariance - *slow.covariance).norm(), 0.01 * slow.covariance->norm());
  }
}

// Wherever the points are, however they scatter: what is answered the short way is what the long way answers, and what
// the long way refuses is refused.
TEST(FastSphere, AFewPointsAnywhereOnAHemisphere) {
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> count(5, 9);
  int answered = 0;
  for (int draw = 0; draw < 70000; ++draw) {
    const double scatter = std::pow(10.0, -draw % 7);
    Eigen::Matrix3Xd points(3, count(engine));
    for (auto point : points.colwise()) {
      Eigen::Vector3d direction;
      for (double& coordinate : direction) {
        coordinate = normal(engine);
      }
      direction.z() = std::abs(direction.z());
      point = Eigen::Vector3d(100.0, -40.0, 7.0) + (12.5 + scatter * normal(engine)) * direction.normalized();
    }
    const auto fast = fitting::fit_plain_sphere(points, {});
    if (!fast) {
      continue;
    }
    ++answered;
    FitOptions options;
    options.weights = Eigen::VectorXd::Ones(points.cols());
    const auto slow = fit<Sphere>(points, options);
    ASSERT_TRUE(slow.has_value()) << "draw " << draw << ": " << slow.error().message;
    EXPECT_LT(apart(fast->feature, slow->feature).length, 1e-10) << draw;
  }
  EXPECT_GT(answered, 50000);
}

TEST(FastSphere, HalfABallAndAThirdOfOne) {
  for (const double lowest : {0.0, 0.35}) {
    auto points = Shape<Sphere>::points(200'000, 0.02);
    const Sphere truth = Shape<Sphere>::truth();
    Eigen::Index kept = 0;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if ((points.col(i) - truth.centre).dot(a_direction) > lowest * truth.radius) {
        points.col(kept++) = points.col(i);
      }
    }
    const Eigen::Matrix3Xd part = points.leftCols(kept);
    const auto fast = fitting::fit_plain_sphere(part, {});
    ASSERT_TRUE(fast.has_value());
    EXPECT_LT(apart(fast->feature, the_long_way(part).feature).length, 5e-12);
  }
}

TEST(FastSphere, OfKnownRadius) {
  for (const int count : {5, 6, 25, 1000, 20'000, 200'003}) {
    SCOPED_TRACE(count);
    const auto points = moved(a_motion(), Shape<Sphere>::points(count, 0.01));
    FitOptions options;
    options.fixed_radius = Shape<Sphere>::truth().radius + 0.003;
    const auto fast = fitting::fit_plain_sphere(points, options);
    ASSERT_TRUE(fast.has_value());
    options.weights = Eigen::VectorXd::Ones(points.cols());
    const auto slow = fit<Sphere>(points, options).value();
    EXPECT_LT((fast->feature.centre - slow.feature.centre).norm(), 1e-12);
    EXPECT_EQ(fast->feature.radius, *options.fixed_radius);
    EXPECT_EQ(fast->degrees_of_freedom, slow.degrees_of_freedom);
    EXPECT_NEAR(*fast->noise, *slow.noise, 1e-12);
    EXPECT_LT((*fast->covariance - *slow.covariance).norm(), 0.01 * slow.covariance->norm());
  }
}

TEST(FastSphere, LeavesWhatIsNotPlainToTheGeneralFit) {
  auto points = Shape<Sphere>::points(50, 0.01);
  FitOptions options;
  options.weights = Eigen::VectorXd::Ones(50);
  EXPECT_FALSE(fitting::fit_plain_sphere(points, options));
  EXPECT_FALSE(fitting::fit_plain_sphere(points.leftCols(4), {}));
  EXPECT_FALSE(fitting::fit_plain_sphere(Shape<Circle>::points(50, 0.001), {}));
  EXPECT_FALSE(fitting::fit_plain_sphere(Eigen::Matrix3Xd::Constant(3, 50, 2.0), {}));
  points(2, 30) = std::nan("");
  EXPECT_FALSE(fitting::fit_plain_sphere(points, {}));
}

TEST(FastSphere, ANaNAmongAMillionIsFound) {
  auto points = Shape<Sphere>::points(1'000'000, 0.01);
  points(1, 777'777) = std::nan("");
  const auto fitted = fit<Sphere>(points);
  ASSERT_FALSE(fitted);
  EXPECT_NE(fitted.error().message.find("777777"), std::string::npos);
}

}  // namespace
}  // namespace artcal::test
