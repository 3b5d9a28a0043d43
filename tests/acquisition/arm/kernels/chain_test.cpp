// Every variant that this machine has, through ForwardKinematics, against one posture at a time.
#include "acquisition/arm/kernels/chain.h"

#include <cmath>

#include <gtest/gtest.h>

#include "acquisition/arm/forward_kinematics.h"
#include "core/random.h"
#include "tests/support/random_arm.h"

namespace artcal {
namespace {

struct Postures {
  Arm arm;
  std::vector<Parameter> parameters;
  std::vector<double> q, sines;  // of one posture after the other

  [[nodiscard]] JointReading reading(int i) const {
    const std::size_t joints = arm.joints.size();
    return {{sines.data() + 2 * joints * static_cast<std::size_t>(i), 2 * joints},
            {q.data() + joints * static_cast<std::size_t>(i), joints}};
  }
};

Postures postures_of(int index) {
  RandomStream random(8, "chain", static_cast<std::uint64_t>(index));
  Postures postures;
  postures.arm = testing::random_arm(random);
  if (index % 3 == 0) {
    postures.arm.joints.back().type = JointType::Prismatic;
  }
  postures.parameters = parameters_of(postures.arm);
  for (int i = 0; i < postures_at_once; ++i) {
    const auto q = testing::random_joints(random, postures.arm.joints.size());
    postures.q.insert(postures.q.end(), q.begin(), q.end());
  }
  postures.sines.resize(2 * postures.q.size());
  joint_sines(postures.q, postures.sines);
  return postures;
}

TEST(Chain, OfEightPosturesHasTheBytesOfEach) {
  for (int index = 0; index < 60; ++index) {
    const Postures postures = postures_of(index);
    const int probe = index % static_cast<int>(postures.arm.probes.size());
    const ForwardKinematics kinematics(postures.arm, postures.parameters, probe);
    const int columns = kinematics.column_count();
    for (const int count : {1, 3, 8}) {
      std::vector<JointReading> readings;
      for (int i = 0; i < count; ++i) {
        readings.push_back(postures.reading(i));
      }
      std::vector<double> tips(3 * postures_at_once);
      std::vector<double> derivative(tips.size() * static_cast<std::size_t>(columns));
      kinematics.tips_in_base(readings, tips.data(), derivative.data());
      std::vector<double> tips_alone(tips.size());
      kinematics.tips_in_base(readings, tips_alone.data(), nullptr);
      for (int i = 0; i < count; ++i) {
        Eigen::Matrix3Xd expected(3, columns);
        const Eigen::Vector3d tip = kinematics.tip_in_base(postures.reading(i), expected.data());
        for (int k = 0; k < 3; ++k) {
          ASSERT_EQ(tips[k * postures_at_once + i], tip[k]) << index;
          ASSERT_EQ(tips_alone[k * postures_at_once + i], tip[k]) << index;
          for (int c = 0; c < columns; ++c) {
            ASSERT_EQ(derivative[(3 * c + k) * postures_at_once + i], expected(k, c))
                << postures.parameters[static_cast<std::size_t>(c)].name << ", arm " << index;
          }
        }
      }
    }
  }
}

TEST(Chain, GivesTheSameBytesWithEveryInstructionSet) {
  RandomStream random(9, "links");
  for (const bool is_modified : {false, true}) {
    std::vector<ChainLink> links;
    int column = 0;
    for (int i = 0; i < 7; ++i) {
      const double theta = random.uniform(-3.0, 3.0), alpha = random.uniform(-3.0, 3.0),
                   beta = random.uniform(-3.0, 3.0);
      links.push_back({random.uniform(-300.0, 300.0), random.uniform(-300.0, 300.0), i % 2 == 0 ? 1.0 : -1.0,
                       std::sin(theta), std::cos(theta), std::sin(alpha), std::cos(alpha), std::sin(beta),
                       std::cos(beta), i % 3 == 1, i == 4, column, column + 1, column + 2, column + 3,
                       i % 3 == 1 ? column + 4 : -1});
      column += 5;
    }
    const Chain chain{is_modified, 7, links.data(), {10.0, -20.0, 150.0}, {column, column + 1, -1}, column + 2};
    std::vector<double> sines, q;
    for (int i = 0; i < 7 * postures_at_once; ++i) {
      q.push_back(random.uniform(-3.0, 3.0));
      sines.push_back(std::sin(q.back()));
    }
    for (const double angle : q) {
      sines.push_back(std::cos(angle));
    }
    const auto run = [&](const ChainVariant& variant) {
      std::vector<double> out(3 * postures_at_once * static_cast<std::size_t>(1 + chain.columns), -1.0);
      variant.pass(chain, sines.data(), q.data(), out.data(), out.data() + 3 * postures_at_once);
      return out;
    };
    const auto expected = run(chain_variants().front());
    for (const ChainVariant& variant : chain_variants()) {
      EXPECT_EQ(run(variant), expected) << variant.instructions;
    }
  }
}

}  // namespace
}  // namespace artcal
