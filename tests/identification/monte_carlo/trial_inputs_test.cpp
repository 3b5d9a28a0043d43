// What a trial draws: by its own moments, and sines that are those of the angles drawn.
#include "identification/monte_carlo/trial_inputs.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "core/statistics.h"
#include "identification/monte_carlo/simulated_measurement.h"
#include "tests/support/joint_error_sessions.h"

namespace artcal {
namespace {

constexpr double arc_seconds_2 = 2.0 * units::arcsecond;

class TrialInputsOfABar : public ::testing::Test {
 protected:
  test::Bound bound = testing::bar_session(testing::nominal_arm(), testing::nominal_arm(), 1, {0.0, 0.0}, 3);
  System system = make_system(bound.recording, bound.constraints, bound.recording.arm, {});
};

TEST_F(TrialInputsOfABar, TurnsTheAnglesAndTheSinesAlike) {
  TrialInputs inputs(system, bound.recording, {arc_seconds_2, 0.0, 0.0, 0.0, 1.5, {}});
  double squares = 0.0;
  for (std::uint64_t trial = 0; trial < 3; ++trial) {
    inputs.draw(1, trial);
    const System& drawn = inputs.system();
    ASSERT_EQ(drawn.joints.size(), system.joints.size());
    for (std::size_t i = 0; i < drawn.joints.size(); ++i) {
      EXPECT_NEAR(drawn.sines[2 * i], std::sin(drawn.joints[i]), 1e-14);
      EXPECT_NEAR(drawn.sines[2 * i + 1], std::cos(drawn.joints[i]), 1e-14);
      squares += std::pow(drawn.joints[i] - system.joints[i], 2);
    }
  }
  const double count = 3.0 * static_cast<double>(system.joints.size());
  EXPECT_NEAR(std::sqrt(squares / count) / (1.5 * arc_seconds_2), 1.0, 4.0 / std::sqrt(2.0 * count));
}

// JCGM 101 §6.4.9: what the noise may be is √(ν/χ²ν) of the estimate, so that ν/factor² has mean ν and variance 2ν.
TEST_F(TrialInputsOfABar, DrawsAnEstimatedNoiseByItsDegreesOfFreedom) {
  constexpr int nu = 7;
  constexpr int trials = 3000;
  TrialInputs inputs(system, bound.recording, {0.0, 0.01, 0.0, 0.0, 1.0, nu});
  double sum = 0.0;
  double squares = 0.0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    inputs.draw(1, trial);
    double own = 0.0;
    for (const Eigen::Vector3d& shift : inputs.system().shifts) own += shift.squaredNorm() / 3.0;
    const double factor_squared = own / static_cast<double>(inputs.system().shifts.size()) / 1e-4;
    sum += nu / factor_squared / trials;
    squares += std::pow(nu / factor_squared - nu, 2) / trials;
  }
  EXPECT_NEAR(sum, nu, 4.0 * std::sqrt(2.0 * nu / trials) + 0.03 * nu);  // the shifts' own chance is 1 % of a variance
  EXPECT_NEAR(squares, 2.0 * nu, 0.2 * 2.0 * nu);
}

TEST_F(TrialInputsOfABar, HasOneErrorOfACertificateForAllPlacements) {
  TrialInputs inputs(system, bound.recording, {0.0, 0.01, 0.0, 0.0, 1.0, {}});
  const auto& stated = bound.constraints.distances;
  double squares = 0.0;
  int count = 0;
  for (std::uint64_t trial = 0; trial < 400; ++trial) {
    inputs.draw(1, trial);
    const auto& drawn = inputs.system().constraints->distances;
    std::map<double, double> error_of;  // by the certified length
    ASSERT_EQ(drawn.size(), stated.size());
    for (std::size_t d = 0; d < drawn.size(); ++d) {
      const double error = drawn[d].value - stated[d].value;
      const auto [entry, is_new] = error_of.try_emplace(stated[d].value, error);
      EXPECT_EQ(entry->second, error);
      squares += is_new ? error * error : 0.0;
      count += is_new ? 1 : 0;
    }
    EXPECT_EQ(error_of.size(), 3U);
  }
  EXPECT_NEAR(std::sqrt(squares / count) / 4e-4, 1.0, 4.0 / std::sqrt(2.0 * count));
}

/// Joints with gains, couplings and harmonics far beyond any real one's, so that whatever leaves them out shows.
Arm enormous_errors() {
  Arm arm = testing::nominal_arm();
  for (Joint& joint : arm.joints) {
    joint.errors.gain = 0.4;
    joint.errors.coupling = &joint == &arm.joints.front() ? 0.0 : -0.3;
    joint.errors.cosine = {0.2, 0.1};
    joint.errors.sine = {-0.1, 0.05};
    joint.errors.expansion = 1e-3;  // of which nothing shows at the reference temperature
  }
  return arm;
}

TEST(Measuring, KnowsJointErrorsInWhatItReadsAndInItsNoise) {
  const Arm arm = enormous_errors();
  const testing::ArmNumbers<double> numbers(arm);
  MeasuringPlan plan;
  RandomStream random(1, "postures");
  for (int i = 0; i < 3; ++i) {
    std::array<Eigen::VectorXd, 2> q{Eigen::VectorXd(6), Eigen::VectorXd(6)};
    for (auto& end : q) {
      for (double& angle : end) angle = random.uniform(-3.0, 3.0);
    }
    plan.lengths.push_back({"length", q});
  }
  const auto length_of = [&](const std::array<Eigen::VectorXd, 2>& q) {
    const auto tip = [&](const Eigen::VectorXd& at) {
      return testing::tip_with_errors(numbers, std::vector<double>(at.begin(), at.end()), 0, 0.0);
    };
    return (tip(q[1]) - tip(q[0])).norm();
  };
  const Measuring measuring(plan, UncertainArm(arm, {{}, Eigen::MatrixXd(0, 0), arc_seconds_2, 0.0}), arc_seconds_2,
                            0.0);
  constexpr int trials = 2000;
  std::vector<double> values(measuring.quantities().size());
  std::vector<double> squares(3), independent(3);
  for (int trial = 0; trial < trials; ++trial) {
    RandomStream noise(2, "noise", static_cast<std::uint64_t>(trial));
    measuring.measure(arm, noise, values.data());
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(values[2 * i], length_of(plan.lengths[i].q), 1e-9);
      squares[i] += values[2 * i + 1] * values[2 * i + 1] / trials;
      auto q = plan.lengths[i].q;
      for (auto& end : q) {
        for (double& angle : end) angle += arc_seconds_2 * random.normal();
      }
      independent[i] += std::pow(length_of(q) - values[2 * i], 2) / trials;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::sqrt(squares[i] / independent[i]), 1.0, 4.0 / std::sqrt(trials)) << i;
    EXPECT_NEAR(std::sqrt(squares[i]) / *measuring.quantities()[2 * i + 1].u_linear, 1.0, 3.0 / std::sqrt(trials));
  }
}

}  // namespace
}  // namespace artcal
