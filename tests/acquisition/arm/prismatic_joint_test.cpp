// Prismatic joints and mechanical couplings: tips by 4 x 4 matrices, derivatives by differences of these.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/arm/arm_text.h"
#include "acquisition/arm/forward_kinematics.h"
#include "core/random.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/random_arm.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

struct Drawn {
  Arm arm;
  std::vector<double> q, sines;
};

Drawn drawn(std::uint64_t seed, bool with_errors) {
  RandomStream random(seed, "prismatic");
  Drawn made{testing::random_arm(random), {}, {}};
  made.q = testing::random_joints(random, made.arm.joints.size());
  for (std::size_t i = 0; i < made.q.size(); ++i) {
    Joint& joint = made.arm.joints[i];
    if (random.uniform() < 0.4) {
      joint.type = JointType::Prismatic;
      made.q[i] *= 200.0;
    } else if (i > 0 && !made.arm.joints[i - 1].is_prismatic() && random.uniform() < 0.5) {
      joint.mechanical_coupling = random.uniform() < 0.5 ? 1.0 : -1.0;
    }
    if (with_errors) {
      joint.errors.gain = 1e-3 * random.normal();
      joint.errors.expansion = 1e-5 * random.normal();
      if (!joint.is_prismatic()) {
        joint.errors.cosine[0] = 1e-3 * random.normal();
        joint.mass = random.uniform(0.1, 2.0);
        joint.errors.compliance = 1e-7 * random.uniform();
      }
    }
    joint.mass = joint.mass.value_or(0.5);
  }
  made.sines.resize(2 * made.q.size());
  joint_sines(made.q, made.sines);
  return made;
}

TEST(PrismaticJoints, PutTheTipWhereMatricesPutIt) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Drawn made = drawn(seed, seed % 2 == 1);
    const ForwardKinematics kinematics(made.arm, {}, 0);
    const Eigen::Vector3d tip = kinematics.tip_in_base({made.sines, made.q, 25.0});
    const Eigen::Vector3d expected = testing::tip_with_errors(testing::ArmNumbers<double>(made.arm), made.q, 0,
                                                              25.0 - made.arm.reference_temperature);
    EXPECT_LT((tip - expected).norm(), 1e-8) << seed;
  }
}

// Central differences of the tip itself, by every parameter and by every reading.
TEST(PrismaticJoints, HaveTheirDerivatives) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Drawn made = drawn(seed, seed % 2 == 1);
    const auto parameters = all_parameters(made.arm);
    const ForwardKinematics kinematics(made.arm, parameters, 0);
    Eigen::Matrix3Xd derivative(3, static_cast<Eigen::Index>(parameters.size()));
    kinematics.tip_in_base({made.sines, made.q, 25.0}, derivative.data());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].kind == ParameterKind::Radius) continue;
      const double step = parameters[i].is_length()                         ? 1e-3
                          : parameters[i].kind == ParameterKind::Compliance ? 1e-10
                                                                            : 1e-7;
      const auto tip_at_step = [&](double by) {
        Arm arm = made.arm;
        set_value(arm, parameters[i], value(arm, parameters[i]) + by);
        return ForwardKinematics(arm, {}, 0).tip_in_base({made.sines, made.q, 25.0});
      };
      const Eigen::Vector3d slope = (tip_at_step(step) - tip_at_step(-step)) / (2.0 * step);
      const Eigen::Vector3d column = derivative.col(static_cast<Eigen::Index>(i));
      EXPECT_LT((column - slope).norm(), 1e-4 * (10.0 + slope.norm())) << seed << " " << parameters[i].name;
    }
    Eigen::Matrix3Xd by_joints(3, static_cast<Eigen::Index>(made.q.size()));
    kinematics.tip_by_joints({made.sines, made.q, 25.0}, by_joints.data());
    for (std::size_t i = 0; i < made.q.size(); ++i) {
      const double step = made.arm.joints[i].is_prismatic() ? 1e-3 : 1e-6;
      const auto tip_at_step = [&](double by) {
        std::vector<double> q = made.q;
        q[i] += by;
        std::vector<double> sines(2 * q.size());
        joint_sines(q, sines);
        return ForwardKinematics(made.arm, {}, 0).tip_in_base({sines, q, 25.0});
      };
      const Eigen::Vector3d slope = (tip_at_step(step) - tip_at_step(-step)) / (2.0 * step);
      EXPECT_LT((by_joints.col(static_cast<Eigen::Index>(i)) - slope).norm(), 1e-5 * (10.0 + slope.norm())) << seed;
    }
  }
}

TEST(PrismaticJoints, ComeBackFromAnArmFile) {
  Arm arm = drawn(3, false).arm;
  arm.joints[0].type = JointType::Prismatic;
  arm.joints[0].lowest = -100.0;
  arm.joints[0].highest = 900.5;
  const auto back = arm_of_text(arm_file_text(arm, std::nullopt), "arm.toml");
  ASSERT_TRUE(back) << back.error().text();
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    EXPECT_EQ(back->joints[i].type, arm.joints[i].type);
    EXPECT_EQ(back->joints[i].mechanical_coupling, arm.joints[i].mechanical_coupling);
    EXPECT_EQ(back->joints[i].lowest, arm.joints[i].lowest);
    EXPECT_EQ(back->joints[i].highest, arm.joints[i].highest);
  }
}

// No gear errs by a whole turn a turn: a coupling of 1 is the convention.
TEST(MechanicalCoupling, IsWhatACouplingOfOneMeans) {
  const auto arm = arm_of_text(
      "schema = \"artcal-arm/1\"\nconvention = \"standard\"\nunits = { length = \"mm\", angle = \"deg\" "
      "}\n[[joint]]\na = "
      "1\nd = 0\ntheta = 0\nalpha = 90\n[[joint]]\na = 1\nd = 0\ntheta = 0\nalpha = 90\ncoupling = -1\n[[probe]]\nl = "
      "100\n",
      "arm.toml");
  ASSERT_TRUE(arm) << arm.error().text();
  EXPECT_EQ(arm->joints[1].mechanical_coupling, -1.0);
  EXPECT_EQ(arm->joints[1].errors.coupling, 0.0);
}

TEST(PrismaticJoints, WhatTheyCannotHaveIsRefused) {
  const auto refusal = [](const std::string& first, const std::string& second) {
    const std::string plain = "[[joint]]\na = 1\nd = 0\ntheta = 0\nalpha = 90\n";
    return arm_of_text(
               "schema = \"artcal-arm/1\"\nconvention = \"standard\"\nunits = { length = \"mm\", angle = \"deg\" }\n" +
                   plain + first + plain + second + "[[probe]]\nl = 100\n",
               "arm.toml")
        .error()
        .text();
  };
  EXPECT_THAT(refusal("type = \"sliding\"\n", ""), HasSubstr("expected \"revolute\" or \"prismatic\""));
  EXPECT_THAT(refusal("type = \"prismatic\"\ncos_q = 0.001\n", ""), HasSubstr("a prismatic joint has no errors"));
  EXPECT_THAT(refusal("type = \"prismatic\"\n", "mechanical_coupling = 1\n"),
              HasSubstr("joint 2 is coupled to the joint before it, but that one is prismatic"));
  EXPECT_THAT(refusal("mechanical_coupling = 1\n", ""),
              HasSubstr("joint 1 is coupled to the joint before it, but it is"));
  EXPECT_THAT(refusal("", "coupling = 0.9\n"), HasSubstr("state `mechanical_coupling = 0.9`"));
}

}  // namespace
}  // namespace artcal
