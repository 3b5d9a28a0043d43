#include "identification/evaluation/stationarity.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

// One block without nuisance unknowns: rows of [arm | residual].
ResidualParts parts_of(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual) {
  Linearisation linearisation;
  Eigen::MatrixXd rows(jacobian.rows(), jacobian.cols() + 1);
  rows << jacobian, residual;
  linearisation.blocks.push_back({-1, 0, {}, rows});
  linearisation.layout.arm = 0;
  linearisation.layout.size = static_cast<int>(jacobian.cols());
  return residual_parts(linearisation, static_cast<int>(jacobian.cols()));
}

// By hand: the tangent space of the columns (1, 0, 0) and (1, 1, 0) is the plane z = 0.
TEST(Stationarity, SplitsTheResidualByTheTangentSpace) {
  Eigen::MatrixXd jacobian(3, 2);
  jacobian << 1, 1, 0, 1, 0, 0;
  const ResidualParts parts = parts_of(jacobian, Eigen::Vector3d(3.0, 4.0, 12.0));
  EXPECT_NEAR(parts.tangential, 5.0, 1e-12);
  EXPECT_NEAR(parts.orthogonal, 12.0, 1e-12);
}

// Parameters that describe the same directions badly, by a factor of 1e9, change nothing: the split is of the model.
TEST(Stationarity, DoesNotDependOnTheParameters) {
  const Eigen::MatrixXd good = Eigen::MatrixXd::Random(12, 4);
  Eigen::Matrix4d mix = Eigen::Matrix4d::Random();
  mix.col(3) = mix.col(2) + 1e-9 * mix.col(3);
  const Eigen::VectorXd residual = Eigen::VectorXd::Random(12);
  const ResidualParts parts = parts_of(good, residual);
  const ResidualParts same = parts_of(good * mix, residual);
  EXPECT_NEAR(same.tangential, parts.tangential, 1e-5);
  EXPECT_NEAR(same.orthogonal, parts.orthogonal, 1e-5);
}

TEST(Stationarity, IsARelativeOffsetBelowAThousandth) {
  EXPECT_TRUE(is_stationary({0.9e-3, 1.0}, 1, 1, 0.0));
  EXPECT_FALSE(is_stationary({1.1e-3, 1.0}, 1, 1, 0.0));
  EXPECT_TRUE(is_stationary({1.1e-3, 1.0}, 100, 400, 0.0));  // by degrees of freedom
  EXPECT_TRUE(is_stationary({1e-7, 0.0}, 10, 10, 1e-6));     // of readings without noise
}

}  // namespace
}  // namespace artcal
