// The covariance that a fit states, against the scatter of a thousand fits.
#include <gtest/gtest.h>

#include "core/normal_vector.h"
#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

// Points that may slide are brought back across the axis or along the normal of the true feature, where
// the covariance lets them move.
Sphere settled(const Sphere& f, const Sphere&) { return f; }
Plane settled(Plane f, const Plane& truth) {
  f.point = truth.point + truth.normal * (f.normal.dot(f.point - truth.point) / f.normal.dot(truth.normal));
  return f;
}
template <typename Axial>
Axial converged_axis(Axial f, const Axial& truth) {
  const double along = truth.direction.dot(truth.point - f.point) / truth.direction.dot(f.direction);
  f.point += along * f.direction;
  if constexpr (std::is_same_v<Axial, Cone>) {
    f.radius += along * std::tan(f.half_angle);
  }
  return f;
}
Line settled(const Line& f, const Line& truth) { return converged_axis(f, truth); }
Cylinder settled(const Cylinder& f, const Cylinder& truth) { return converged_axis(f, truth); }
Cone settled(const Cone& f, const Cone& truth) { return converged_axis(f, truth); }
Circle settled(const Circle& f, const Circle&) { return f; }

template <typename F>
void expect_stated_scatter(const FitOptions& base = {}, const Eigen::VectorXd& sigmas = {}) {
  constexpr int n = F::parameter_count;
  constexpr double noise = 0.002;
  constexpr int runs = 1500;
  const Eigen::Matrix3Xd exact = Shape<F>::points(20, 0.0);
  const auto central = fit<F>(exact, base);
  ASSERT_TRUE(central);
  const F truth = central->feature;
  Eigen::Matrix<double, n, n> scatter = Eigen::Matrix<double, n, n>::Zero();
  Eigen::Matrix<double, n, n> stated = Eigen::Matrix<double, n, n>::Zero();
  for (int run = 0; run < runs; ++run) {
    RandomStream random(11, "covariance", static_cast<std::uint64_t>(run));
    Eigen::Matrix3Xd points = exact;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const double sigma = sigmas.size() == 0 ? noise : noise * sigmas(i);
      points.col(i) += sigma * normal_vector(random);
    }
    FitOptions options = base;
    if constexpr (n >= 6) {
      options.towards = truth.parameters().template segment<3>(3);
    }
    const auto fitted = fit<F>(points, options);
    ASSERT_TRUE(fitted) << fitted.error().text();
    const Eigen::Matrix<double, n, 1> off = settled(fitted->feature, truth).parameters() - truth.parameters();
    scatter += off * off.transpose() / runs;
    stated += *fitted->covariance / runs;
  }
  // Standard deviations of 1500 runs are known to 2 %, correlations to 0.03.
  const Eigen::Matrix<double, n, 1> size = scatter.diagonal().cwiseSqrt().cwiseMax(1e-12);
  const auto relative = (size.cwiseInverse().asDiagonal() * (scatter - stated) * size.cwiseInverse().asDiagonal());
  const Eigen::Matrix<double, n, n> difference = relative;
  for (int i = 0; i < n; ++i) {
    EXPECT_LT(difference.row(i).cwiseAbs().maxCoeff(), 0.12) << i << "\n" << scatter << "\n\n" << stated;
  }
}

TEST(Covariance, Sphere) { expect_stated_scatter<Sphere>(); }
TEST(Covariance, Plane) { expect_stated_scatter<Plane>(); }
TEST(Covariance, Line) { expect_stated_scatter<Line>(); }
TEST(Covariance, CircleProjected) { expect_stated_scatter<Circle>(); }
TEST(Covariance, CircleSpatial) {
  FitOptions options;
  options.circle = CircleConvention::Spatial;
  expect_stated_scatter<Circle>(options);
}
TEST(Covariance, Cylinder) { expect_stated_scatter<Cylinder>(); }
TEST(Covariance, Cone) { expect_stated_scatter<Cone>(); }

TEST(Covariance, GivenNoise) {
  FitOptions options;
  options.noise = 0.002;
  expect_stated_scatter<Sphere>(options);
  expect_stated_scatter<Circle>(options);
  expect_stated_scatter<Cylinder>(options);
}

TEST(Covariance, FixedRadius) {
  FitOptions options;
  options.fixed_radius = Shape<Sphere>::truth().radius;
  expect_stated_scatter<Sphere>(options);
}

TEST(Covariance, WeightsOfUnequalNoise) {
  Eigen::VectorXd sigmas = Eigen::VectorXd::LinSpaced(20, 0.5, 2.0);
  FitOptions options;
  options.weights = sigmas.array().square().inverse();
  options.noise = 0.002;
  expect_stated_scatter<Sphere>(options, sigmas);
  expect_stated_scatter<Plane>(options, sigmas);
  expect_stated_scatter<Cylinder>(options, sigmas);
}

}  // namespace
}  // namespace artcal::test
