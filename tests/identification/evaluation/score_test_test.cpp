#include "identification/evaluation/score_test.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "core/random.h"
#include "core/statistics.h"

namespace artcal {
namespace {

/// A projected problem: fourteen readings of three coordinates, and two rows with one error.
struct Projected {
  Eigen::MatrixXd columns;
  Eigen::VectorXd residuals;
  std::vector<ObservationRows> observations;
};

constexpr int readings = 14;
constexpr int rows = 3 * readings + 2;

Projected projected(const Eigen::MatrixXd& fitted, const Eigen::MatrixXd& effect, const Eigen::VectorXd& errors) {
  const Eigen::MatrixXd left =
      Eigen::MatrixXd::Identity(rows, rows) - fitted * fitted.completeOrthogonalDecomposition().pseudoInverse();
  Projected result;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(left * effect);
  result.columns = qr.householderQ() * Eigen::MatrixXd::Identity(rows, effect.cols());
  result.residuals = left * errors;
  for (int i = 0; i < readings; ++i) {
    result.observations.push_back({3 * i, Eigen::Matrix3d::Identity() - left.block<3, 3>(3 * i, 3 * i), i});
  }
  for (int i = rows - 2; i < rows; ++i) {
    result.observations.push_back({i, Eigen::MatrixXd::Constant(1, 1, 1.0 - left(i, i)), readings});
  }
  return result;
}

double statistic(const Projected& problem) {
  return score_statistic(problem.columns, problem.residuals, leverage_adjusted(problem.residuals, problem.observations),
                         problem.observations);
}

// By numpy 1.24 with a dense hat matrix and scipy's matrix square root (A, Z and e as here; pinv, sqrtm, inv):
// 8.961019250183087.
TEST(ScoreTest, IsWhatNumpyComputes) {
  Eigen::MatrixXd fitted(rows, 3), effect(rows, 2);
  Eigen::VectorXd errors(rows);
  for (int i = 0; i < rows; ++i) {
    fitted.row(i) << 1.0, std::cos(0.7 * i), std::sin(std::fmod(0.3 * i * i, 5.0));
    effect.row(i) << std::sin(1.1 * i), std::cos(0.23 * i) + 0.1 * std::sin(i);
    errors[i] = std::sin(2.3 * i + 0.5) * (1.0 + 0.5 * std::cos(0.4 * i)) + 0.8 * effect(i, 0);
  }
  EXPECT_NEAR(statistic(projected(fitted, effect, errors)), 8.961019250183087, 1e-9);
}

// Errors of three coordinates that are one number, ten times as large in half of the readings: an F test would take
// them for independent ones of one variance and find the effect, which lies where they are large, in one case of four.
TEST(ScoreTest, UnequalCorrelatedErrorsAreNoEffect) {
  Eigen::MatrixXd fitted(rows, 3), effect(rows, 1);
  for (int i = 0; i < rows; ++i) {
    fitted.row(i) << 1.0, std::cos(0.7 * i), std::sin(0.2 * i);
    effect(i, 0) = i < rows / 2 ? std::cos(1.3 * (i / 3)) : 0.0;
  }
  constexpr int trials = 2000;
  int alarms = 0;
  for (int trial = 0; trial < trials; ++trial) {
    RandomStream random(3, "score test", static_cast<std::uint64_t>(trial));
    Eigen::VectorXd errors(rows);
    double error = 0.0;
    for (int i = 0; i < rows; ++i) {
      error = i % 3 == 0 ? (i < rows / 2 ? 10.0 : 1.0) * random.normal() : error;
      errors[i] = error;
    }
    alarms += chi_squared_probability_above(statistic(projected(fitted, effect, errors)), 1.0) < 0.05 ? 1 : 0;
  }
  EXPECT_LT(alarms, 0.06 * trials);
}

TEST(ScoreTest, SaysNothingByFewUnits) {
  Projected few{Eigen::MatrixXd::Ones(9, 1).normalized(), Eigen::VectorXd::Ones(9), {}};
  for (int i = 0; i < 9; ++i) few.observations.push_back({i, Eigen::MatrixXd::Zero(1, 1), i});
  EXPECT_EQ(statistic(few), 0.0);
}

}  // namespace
}  // namespace artcal
