// A simulated AACMM on a ball bar (examples/ball-bar), identified and judged against the arm that an
// independent simulator made the readings with (tests/reference/aacmm-simulated/NOTE.md).
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "acquisition/arm/arm_file.h"
#include "acquisition/arm/forward_kinematics.h"
#include "core/random.h"
#include "tests/support/recordings.h"

namespace artcal {
namespace {

struct LengthErrors {
  double rms = 0.0;
  double maximum = 0.0;
};

// Errors of 20,000 random lengths in the working volume: both ends at random postures.
LengthErrors length_errors(const Arm& truth, const Arm& arm) {
  const ForwardKinematics true_kinematics(truth, {}, 0);
  const ForwardKinematics kinematics(arm, {}, 0);
  RandomStream random(1, "lengths in the volume");
  LengthErrors errors;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d true_apart = Eigen::Vector3d::Zero();
    Eigen::Vector3d apart = Eigen::Vector3d::Zero();
    for (const double end : {-1.0, 1.0}) {
      std::array<double, 6> q;
      for (double& angle : q) angle = random.uniform(-std::numbers::pi, std::numbers::pi);
      std::array<double, 12> sines;
      joint_sines(q, sines);
      true_apart += end * true_kinematics.tip_in_base(sines);
      apart += end * kinematics.tip_in_base(sines);
    }
    const double error = apart.norm() - true_apart.norm();
    errors.rms += error * error / count;
    errors.maximum = std::max(errors.maximum, std::abs(error));
  }
  errors.rms = std::sqrt(errors.rms);
  return errors;
}

class BallBar : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto file = read_arm_file(std::string(ARTCAL_SOURCE_DIR) + "/tests/reference/aacmm-simulated/truth-arm.toml");
    ASSERT_TRUE(file) << file.error().text();
    truth = file->arm;
  }
  test::Bound bound = test::read_bound(test::example("ball-bar/recording.toml"));
  Arm truth;
};

TEST_F(BallBar, TheNominalArmIsTwoMillimetresOff) {
  EXPECT_NEAR(length_errors(truth, bound.recording.arm).rms, 2.111, 0.03);  // another draw of lengths
}

TEST_F(BallBar, TheSameWeightsGiveTheSame) {
  IdentifyOptions options;
  options.noise.reading = 0.015;
  options.leave_out = false;
  const Identification result = test::identified(bound, options);
  const LengthErrors errors = length_errors(truth, result.arm);
  EXPECT_LE(errors.rms, 0.0060);
  EXPECT_NEAR(errors.rms, 0.00597, 0.0002);
  EXPECT_LE(errors.maximum, 0.0200);
  EXPECT_NEAR(result.after.overall.rms, 0.00983, 0.0003);
}

TEST_F(BallBar, NoiseByPostureDoesBetter) {
  IdentifyOptions options;
  options.noise = bound.recording.noise;
  const Identification result = test::identified(bound, options);
  const LengthErrors errors = length_errors(truth, result.arm);
  EXPECT_LE(errors.rms, 0.0050);
  EXPECT_LE(errors.maximum, 0.0160);
  // The stated noise is the simulator's, and the fit knows it.
  EXPECT_GT(result.chi_squared, result.chi_squared_low);
  EXPECT_LT(result.chi_squared, result.chi_squared_high);
  EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
  // All 21 true parameters lie where the uncertainties say: χ² of their deviation, with the covariance.
  Eigen::VectorXd deviation(static_cast<Eigen::Index>(result.free.size()));
  for (Eigen::Index i = 0; i < deviation.size(); ++i) {
    const Parameter& parameter = result.parameters[result.free[i]].parameter;
    deviation[i] = value(result.arm, parameter) - value(truth, parameter);
  }
  EXPECT_EQ(deviation.size(), 21);
  const double chi_squared = deviation.dot(result.covariance.ldlt().solve(deviation));
  EXPECT_GT(chi_squared, 5.9);  // 0.1 % and 99.9 % of χ² with 21 degrees of freedom are 5.9 and 46.8
  EXPECT_LT(chi_squared, 46.8);
}

TEST_F(BallBar, EstimatedNoiseDoesAsWell) {
  const Identification result = test::identified(bound, {});
  EXPECT_LE(length_errors(truth, result.arm).rms, 0.0060);
  EXPECT_EQ(result.left_out.size(), 7u);
  for (const LeftOut& left : result.left_out) {
    EXPECT_EQ(left.refusal, "");
    EXPECT_LT(left.deviation.rms, 0.013);
  }
}

TEST_F(BallBar, WhatIsHeld) {
  const Identification result = test::identified(bound, {});
  for (const char* fixed : {"a6", "d6"}) {
    EXPECT_EQ(test::state_of(result, fixed), ParameterState::Fixed);
    EXPECT_EQ(test::identified_value(result, fixed), 0.0);
  }
  EXPECT_EQ(test::state_of(result, "d1"), ParameterState::Unidentifiable);
  EXPECT_EQ(test::state_of(result, "theta1"), ParameterState::Unidentifiable);
  EXPECT_EQ(result.coupling.rank, 21);
}

}  // namespace
}  // namespace artcal
