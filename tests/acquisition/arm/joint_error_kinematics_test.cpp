#include <algorithm>
#include <cmath>

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "acquisition/arm/forward_kinematics.h"
#include "core/random.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/random_arm.h"

// Arms with all joint errors at once, against their equations written with 4×4 matrices.
namespace artcal {
namespace {

constexpr int arm_count = 60;
constexpr double rounding = 1e-14;  // of the arm's length

constexpr int jet_size = 150;  // nine joints with all that they can have, three tips off the axis, nine readings
using Jet = ceres::Jet<double, jet_size>;

// Errors as large as those of arms that one would send back, so that nothing of second order hides.
void add_errors(Arm& arm, RandomStream& random) {
  const double length = reach(arm);
  for (Joint& joint : arm.joints) {
    for (std::size_t h = 0; h < 2; ++h) {
      joint.errors.cosine[h] = 1e-3 * random.normal();
      joint.errors.sine[h] = 1e-3 * random.normal();
    }
    joint.errors.gain = 1e-3 * random.normal();
    joint.errors.coupling = &joint == &arm.joints.front() ? 0.0 : 1e-3 * random.normal();
    joint.mass = random.uniform(0.1, 3.0);
    joint.errors.compliance = 1e-3 * random.normal() / (10.0 * length);
    joint.errors.expansion = 2e-5 * random.normal();
  }
  arm.gravity_in_base = 9.81 * random.direction();
  arm.reference_temperature = random.uniform(18.0, 23.0);
}

struct Case {
  Arm arm;
  std::vector<double> q, sines;
  int probe = 0;
  double temperature = 20.0;
  std::vector<Parameter> parameters;
  double length = 0.0;

  explicit Case(int index, bool errors = true) {
    RandomStream random(2013, "sweep_errors_test", static_cast<std::uint64_t>(index));
    arm = testing::random_arm(random);
    q = testing::random_joints(random, arm.joints.size());
    for (double& angle : q) {
      angle += 2.0 * std::numbers::pi * std::floor(random.uniform(-1.0, 2.0));  // whole turns count
    }
    sines.resize(2 * q.size());
    joint_sines(q, sines);
    probe = static_cast<int>(random.bits() % arm.probes.size());
    temperature = random.uniform(10.0, 30.0);
    if (errors) {
      add_errors(arm, random);
    }
    parameters = all_parameters(arm);
    length = 1.0 + reach(arm) + std::abs(arm.joints[0].a) + std::abs(arm.joints[0].d);
  }

  [[nodiscard]] JointReading reading() const { return {sines, q, temperature}; }
  [[nodiscard]] double temperature_offset() const { return temperature - arm.reference_temperature; }
};

Eigen::Vector3d expected_tip(const Case& c) {
  return testing::tip_with_errors(testing::ArmNumbers<double>(c.arm), c.q, c.probe, c.temperature_offset());
}

// By the parameters and then by the joint readings.
Eigen::Matrix3Xd expected_derivative(const Case& c) {
  testing::ArmNumbers<Jet> numbers(c.arm);
  int k = 0;
  for (const Parameter& parameter : c.parameters) {
    numbers.at(parameter).v[k++] = 1.0;
  }
  std::vector<Jet> q;
  for (const double angle : c.q) {
    q.emplace_back(angle, k++);
  }
  const auto tip = testing::tip_with_errors(numbers, q, c.probe, c.temperature_offset());
  Eigen::Matrix3Xd derivative(3, k);
  for (int row = 0; row < 3; ++row) {
    derivative.row(row) = tip[row].v.head(k).transpose();
  }
  return derivative;
}

TEST(ForwardKinematicsWithErrors, TipIsThatOfTheEquations) {
  for (int i = 0; i < arm_count; ++i) {
    const Case c(i);
    const ForwardKinematics kinematics(c.arm, c.parameters, c.probe);
    const Eigen::Vector3d tip = kinematics.tip_in_base(c.reading());
    ASSERT_LT((tip - expected_tip(c)).norm(), 4 * rounding * c.length) << "arm " << i;
    std::vector<double> derivative(3 * (c.parameters.size() + c.q.size()));
    ASSERT_EQ(tip, kinematics.tip_in_base(c.reading(), derivative.data())) << "arm " << i;
    ASSERT_EQ(tip, kinematics.tip_by_joints(c.reading(), derivative.data())) << "arm " << i;
    std::vector<double> points(3 * c.q.size());
    ASSERT_EQ(tip, kinematics.axes_in_base(c.reading(), derivative.data(), points.data())) << "arm " << i;
  }
}

TEST(ForwardKinematicsWithErrors, DerivativesAreTheAutomaticOnes) {
  // With the errors, and at the rigid arm where an identification begins.
  for (const bool errors : {true, false}) {
    for (int i = 0; i < arm_count; ++i) {
      Case c(i, errors);
      for (Joint& joint : c.arm.joints) {
        joint.mass = 1.0;
      }
      const auto count = static_cast<Eigen::Index>(c.parameters.size());
      ASSERT_LE(count + static_cast<Eigen::Index>(c.q.size()), jet_size);
      const Eigen::Matrix3Xd expected = expected_derivative(c);
      Eigen::Matrix3Xd derivative(3, count);
      const ForwardKinematics kinematics(c.arm, c.parameters, c.probe);
      kinematics.tip_in_base(c.reading(), derivative.data());
      for (int k = 0; k < count; ++k) {
        const Parameter& parameter = c.parameters[static_cast<std::size_t>(k)];
        const double size = std::max(expected.col(k).norm(), parameter.is_length() ? 1.0 : c.length);
        ASSERT_LT((derivative.col(k) - expected.col(k)).norm(), 2e-12 * size) << "arm " << i << ", " << parameter.name;
      }
      Eigen::Matrix3Xd by_joints(3, static_cast<Eigen::Index>(c.q.size()));
      kinematics.tip_by_joints(c.reading(), by_joints.data());
      ASSERT_LT((by_joints - expected.rightCols(by_joints.cols())).norm(), 1e-12 * c.length) << "arm " << i;
    }
  }
}

TEST(ForwardKinematicsWithErrors, DerivativesAreTheCentralDifferences) {
  for (int i = 0; i < arm_count; ++i) {
    const Case c(i);
    Eigen::Matrix3Xd derivative(3, static_cast<Eigen::Index>(c.parameters.size()));
    ForwardKinematics(c.arm, c.parameters, c.probe).tip_in_base(c.reading(), derivative.data());
    for (int k = 0; k < derivative.cols(); ++k) {
      const Parameter& parameter = c.parameters[static_cast<std::size_t>(k)];
      const double h = parameter.is_length() ? 0.1 : 1e-2 * physical_scale(parameter, c.length);
      const auto tip_at = [&](double step) {
        Arm moved = c.arm;
        set_value(moved, parameter, value(c.arm, parameter) + step);
        return ForwardKinematics(moved, {}, c.probe).tip_in_base(c.reading());
      };
      const Eigen::Vector3d slope = (tip_at(h) - tip_at(-h)) / (2.0 * h);
      ASSERT_LT((derivative.col(k) - slope).norm() * h, 1e-10 * c.length) << "arm " << i << ", " << parameter.name;
    }
  }
}

// Gao's arm held out level: 2 kg at the end of the last link but one, worked out by hand.
TEST(ForwardKinematicsWithErrors, AStretchedArmSagsByItsWeight) {
  Arm arm;
  arm.joints = {{.a = 0.0, .d = 300.0, .theta = 0.0, .alpha = std::acos(0.0)}, {.a = 1000.0, .d = 0.0}};
  arm.probes.push_back({"probe", {0.0, 0.0, 0.0}, 0.0, false});
  arm.joints[1].mass = 2.0;
  arm.joints[1].errors.compliance = 1e-7;
  std::vector<double> sines(4);
  const std::vector<double> q{0.0, 0.0};
  joint_sines(q, sines);
  const Eigen::Vector3d tip = ForwardKinematics(arm, {}, 0).tip_in_base({sines, q});
  // 2 kg at half a metre: 9807 N·mm. The arm goes down.
  EXPECT_NEAR(tip.z(), 300.0 - 1000.0 * std::sin(9806.65 * 1e-7), 1e-6);
  EXPECT_NEAR(tip.x(), 1000.0, 1e-3);
}

}  // namespace
}  // namespace artcal
