#include "acquisition/arm/forward_kinematics.h"

#include <array>
#include <cmath>

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/random_arm.h"
#include "tests/support/sanitizers/allocations.h"

namespace artcal {
namespace {

constexpr int arm_count = 400;
// Rounding alone, relative to the arm's length: an entry is a sum of some tens of products.
constexpr double rounding = 5e-15;
// Central differences: step²/6 times the third derivative, and rounding/step; relative to the same.
constexpr double step = 1e-5;
constexpr double by_differences = 2e-10;

constexpr int jet_size = 80;  // nine joints with β, three tips off the axis with radii, nine joint readings
using Jet = ceres::Jet<double, jet_size>;

struct Case {
  Arm arm;
  std::vector<double> q;
  int probe = 0;
  std::vector<Parameter> parameters;
  double length = 0.0;  // no entry of a tip, nor of a column of an angle, is larger

  explicit Case(int index) {
    RandomStream random(2013, "sweep_test", static_cast<std::uint64_t>(index));
    arm = testing::random_arm(random);
    q = testing::random_joints(random, arm.joints.size());
    probe = static_cast<int>(random.bits() % arm.probes.size());
    parameters = parameters_with_radii(arm);
    length = 1.0 + reach(arm) + std::abs(arm.joints[0].a) + std::abs(arm.joints[0].d);
  }

  [[nodiscard]] double scale(int column) const { return parameters[column].is_angle() ? length : 1.0; }
};

std::vector<double> sines_of(const std::vector<double>& q) {
  std::vector<double> sines(2 * q.size());
  joint_sines(q, sines);
  return sines;
}

Eigen::Vector3d tip_of(const Arm& arm, const std::vector<double>& q, int probe) {
  return ForwardKinematics(arm, {}, probe).tip_in_base(sines_of(q));
}

Eigen::Matrix3Xd structural_derivative(const Case& c) {
  Eigen::Matrix3Xd derivative(3, static_cast<Eigen::Index>(c.parameters.size()));
  ForwardKinematics(c.arm, c.parameters, c.probe).tip_in_base(sines_of(c.q), derivative.data());
  return derivative;
}

Eigen::Matrix3Xd derivative_by_joints(const Case& c) {
  Eigen::Matrix3Xd derivative(3, static_cast<Eigen::Index>(c.q.size()));
  ForwardKinematics(c.arm, c.parameters, c.probe).tip_by_joints(sines_of(c.q), derivative.data());
  return derivative;
}

// The derivative of the product of matrices, by the parameters and then by the joint readings.
Eigen::Matrix3Xd automatic_derivative(const Case& c) {
  testing::ArmNumbers<Jet> numbers(c.arm);
  int k = 0;
  for (const Parameter& parameter : c.parameters) {
    numbers.at(parameter).v[k++] = 1.0;
  }
  std::vector<Jet> q;
  for (const double angle : c.q) {
    q.emplace_back(angle, k++);
  }
  const auto tip = testing::tip_in_base(numbers, q, c.probe);
  Eigen::Matrix3Xd derivative(3, k);
  for (int row = 0; row < 3; ++row) {
    derivative.row(row) = tip[row].v.head(k).transpose();
  }
  return derivative;
}

TEST(ForwardKinematics, TipIsTheProductOfTheMatrices) {
  for (int i = 0; i < arm_count; ++i) {
    const Case c(i);
    const auto expected = testing::tip_in_base(testing::ArmNumbers<double>(c.arm), c.q, c.probe);
    ASSERT_LT((tip_of(c.arm, c.q, c.probe) - expected).norm(), rounding * c.length) << "arm " << i;
  }
}

TEST(ForwardKinematics, EveryCallGivesTheSameTip) {
  for (int i = 0; i < arm_count; ++i) {
    const Case c(i);
    const ForwardKinematics kinematics(c.arm, c.parameters, c.probe);
    const auto sines = sines_of(c.q);
    std::vector<double> derivative(3 * std::max(c.parameters.size(), c.q.size()));
    const Eigen::Vector3d tip = kinematics.tip_in_base(sines);
    ASSERT_EQ(tip, kinematics.tip_in_base(sines, derivative.data())) << "arm " << i;
    ASSERT_EQ(tip, kinematics.tip_by_joints(sines, derivative.data())) << "arm " << i;
  }
}

TEST(ForwardKinematics, StructuralDerivativeIsTheAutomaticOne) {
  for (int i = 0; i < arm_count; ++i) {
    const Case c(i);
    const Eigen::Matrix3Xd difference =
        structural_derivative(c) - automatic_derivative(c).leftCols(static_cast<Eigen::Index>(c.parameters.size()));
    for (int k = 0; k < difference.cols(); ++k) {
      ASSERT_LT(difference.col(k).norm(), rounding * c.scale(k))
          << "arm " << i << ", parameter " << c.parameters[k].name;
    }
  }
}

TEST(ForwardKinematics, StructuralDerivativeIsTheCentralDifference) {
  for (int i = 0; i < arm_count; ++i) {
    const Case c(i);
    const Eigen::Matrix3Xd derivative = structural_derivative(c);
    for (int k = 0; k < derivative.cols(); ++k) {
      const Parameter& parameter = c.parameters[k];
      // A tip is linear in a length, so that there a longer step costs nothing and rounds less.
      const double h = parameter.is_angle() ? step : 1.0;
      Arm moved = c.arm;
      set_value(moved, parameter, value(c.arm, parameter) + h);
      const Eigen::Vector3d above = tip_of(moved, c.q, c.probe);
      set_value(moved, parameter, value(c.arm, parameter) - h);
      const Eigen::Vector3d below = tip_of(moved, c.q, c.probe);
      ASSERT_LT((derivative.col(k) - (above - below) / (2.0 * h)).norm(), by_differences * c.length)
          << "arm " << i << ", parameter " << parameter.name;
    }
  }
}

TEST(ForwardKinematics, DerivativeByJointsIsTheAutomaticOneAndTheCentralDifference) {
  for (int i = 0; i < arm_count; ++i) {
    const Case c(i);
    const Eigen::Matrix3Xd derivative = derivative_by_joints(c);
    ASSERT_LT((derivative - automatic_derivative(c).rightCols(derivative.cols())).norm(), 2 * rounding * c.length);
    for (int k = 0; k < derivative.cols(); ++k) {
      std::vector<double> above = c.q;
      std::vector<double> below = c.q;
      above[k] += step;
      below[k] -= step;
      const Eigen::Vector3d slope = (tip_of(c.arm, above, c.probe) - tip_of(c.arm, below, c.probe)) / (2.0 * step);
      ASSERT_LT((derivative.col(k) - slope).norm(), by_differences * c.length) << "arm " << i << ", joint " << k + 1;
    }
  }
}

TEST(ForwardKinematics, ColumnsFollowTheParametersAskedFor) {
  for (int i = 0; i < arm_count; ++i) {
    const Case c(i);
    const Eigen::Matrix3Xd all = structural_derivative(c);
    // Every third one, backwards.
    std::vector<Parameter> some;
    std::vector<Eigen::Index> columns;
    for (int k = static_cast<int>(c.parameters.size()) - 1; k >= 0; k -= 3) {
      some.push_back(c.parameters[k]);
      columns.push_back(k);
    }
    Eigen::Matrix3Xd selected = Eigen::Matrix3Xd::Constant(3, static_cast<Eigen::Index>(some.size()), 1e300);
    const ForwardKinematics kinematics(c.arm, some, c.probe);
    ASSERT_EQ(kinematics.column_count(), selected.cols());
    kinematics.tip_in_base(sines_of(c.q), selected.data());
    ASSERT_EQ(selected, all(Eigen::all, columns)) << "arm " << i;
  }
}

TEST(ForwardKinematics, TipsOfOtherProbesDoNotMoveThisOne) {
  int seen = 0;
  for (int i = 0; i < arm_count; ++i) {
    const Case c(i);
    const Eigen::Matrix3Xd derivative = structural_derivative(c);
    for (int k = 0; k < derivative.cols(); ++k) {
      const Parameter& parameter = c.parameters[k];
      if (parameter.is_tip() && parameter.owner != c.probe) {
        ASSERT_EQ(derivative.col(k), Eigen::Vector3d::Zero().eval());
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, arm_count / 2);
}

TEST(ForwardKinematics, AllocatesNothing) {
  if (!testing::counts_allocations) {
    GTEST_SKIP() << "a sanitizer owns malloc";
  }
  const Case c(3);
  const ForwardKinematics kinematics(c.arm, c.parameters, c.probe);
  Arm bent = c.arm;
  bent.joints[0].errors = {{1e-4, 0.0}, {0.0, 1e-4}, 1e-4, 0.0, 1e-8, 1e-5};
  bent.joints[0].mass = 1.0;
  const ForwardKinematics bent_kinematics(bent, all_parameters(bent), c.probe);
  std::vector<double> sines(2 * c.q.size());
  std::vector<double> derivative(3 * static_cast<std::size_t>(bent_kinematics.column_count()));
  const long before = testing::allocation_count.load();
  joint_sines(c.q, sines);
  Eigen::Vector3d tip = kinematics.tip_in_base(sines);
  tip += kinematics.tip_in_base(sines, derivative.data());
  tip += kinematics.tip_by_joints(sines, derivative.data());
  tip += bent_kinematics.tip_in_base({sines, c.q}, derivative.data());
  tip += bent_kinematics.tip_by_joints({sines, c.q}, derivative.data());
  const long allocations = testing::allocation_count.load() - before;
  EXPECT_EQ(allocations, 0) << tip;
  // The counter itself counts.
  const Eigen::MatrixXd seen = Eigen::MatrixXd::Zero(c.arm.joints.size() + 3, 30);
  EXPECT_GT(testing::allocation_count.load(), before) << seen.size();
}

// The arm of Gao, Lu, Yang 2013 stretched out along its axes: worked out by hand.
TEST(ForwardKinematics, KnownPoseOfAKnownArm) {
  Arm arm;
  const double right = std::acos(0.0);
  for (const double d : {300.0, 65.5, 792.7, 65.5, 883.2, 0.0}) {
    arm.joints.push_back({0.0, d, 0.0, right, 0.0, 1.0, false});
  }
  arm.probes.push_back({"probe", {0.0, 0.0, 183.5}, 0.0, true});
  // All zero: the frames turn by 90° about x each time, so z(i) runs z, -y, -z, y, z, -y, -z.
  const Eigen::Vector3d tip = tip_of(arm, std::vector<double>(6, 0.0), 0);
  EXPECT_LT((tip - Eigen::Vector3d(0.0, -65.5 + 65.5, 300.0 - 792.7 + 883.2 - 183.5)).norm(), 1e-12);
  EXPECT_NEAR(reach(arm), 65.5 + 792.7 + 65.5 + 883.2 + 183.5, 1e-12);
}

TEST(JointReading, AreSineAndCosineInTurn) {
  const std::array<double, 2> q{0.5, -2.0};
  std::array<double, 4> sines{};
  joint_sines(q, sines);
  EXPECT_EQ(sines, (std::array{std::sin(0.5), std::cos(0.5), std::sin(-2.0), std::cos(-2.0)}));
}

}  // namespace
}  // namespace artcal
