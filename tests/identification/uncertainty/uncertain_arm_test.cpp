// Uncertainty of points, lengths and diameters, against a Monte Carlo that moves the arm by forward kinematics of the
// tests' own and takes the spread of what comes out.
#include "identification/uncertainty/uncertain_arm.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "artefacts/virtual_probing/postures.h"
#include "core/random.h"
#include "core/units.h"
#include "fitting/fit.h"
#include "identification/uncertainty/working_volume.h"
#include "tests/support/arms.h"
#include "tests/support/forward_kinematics.h"

namespace artcal {
namespace {

/// With errors in every joint.
Arm erring_arm() {
  Arm arm = test::gao_arm();
  arm.probes.front().radius = 3.0;
  for (Joint& joint : arm.joints) {
    joint.mass = 1.5;
    joint.errors = {{1e-3, 3e-4}, {-5e-4, 2e-4}, 2e-3, -1e-3, 4e-8, 2e-5};
  }
  arm.joints.front().errors.coupling = 0.0;
  return arm;
}

/// Of everything that an arm has: chain, tip and its radius, joint errors.
UncertaintySources sources_of(const Arm& arm) {
  UncertaintySources sources;
  sources.parameters = all_parameters(arm);
  const auto count = static_cast<Eigen::Index>(sources.parameters.size());
  RandomStream random(5, "covariance");
  Eigen::MatrixXd root(count, count);
  for (double& entry : root.reshaped()) entry = random.normal() / std::sqrt(static_cast<double>(count));
  for (Eigen::Index i = 0; i < count; ++i) {
    root.row(i) *= 0.01 * physical_scale(sources.parameters[i], 1000.0);
    root.row(i) *= sources.parameters[i].kind == ParameterKind::Radius ? 5.0 : 1.0;  // or it would not show
  }
  sources.covariance = root * root.transpose();
  sources.encoder = 4.0 * units::arcsecond;
  sources.probing = 0.006;
  return sources;
}

/// One arm out of the covariance, and readings with noise of their own.
class Draw {
 public:
  Draw(const Arm& arm, const UncertaintySources& sources, std::uint64_t trial)
      : random_(7, "trial", trial), sources_(sources), arm_(arm) {
    const Eigen::MatrixXd root = Eigen::LLT<Eigen::MatrixXd>(sources.covariance).matrixL();
    Eigen::VectorXd normal(root.rows());
    for (double& entry : normal) entry = random_.normal();
    const Eigen::VectorXd change = root * normal;
    for (Eigen::Index i = 0; i < change.size(); ++i) {
      arm_.at(sources.parameters[i]) += change[i];
    }
  }
  Eigen::Vector3d tip(const Eigen::VectorXd& q) {
    std::vector<double> joints(q.begin(), q.end());
    for (double& angle : joints) angle += sources_.encoder * random_.normal();
    Eigen::Vector3d tip = testing::tip_with_errors(arm_, joints, 0, 0.0);
    for (double& coordinate : tip) coordinate += sources_.probing * random_.normal();
    return tip;
  }

  [[nodiscard]] double tip_radius() const { return arm_.radii[0]; }

 private:
  RandomStream random_;
  const UncertaintySources& sources_;
  testing::ArmNumbers<double> arm_;
};

Eigen::VectorXd posture(std::uint64_t index) {
  RandomStream random(11, "posture", index);
  Eigen::VectorXd q(6);
  for (double& angle : q) angle = random.uniform(-std::numbers::pi, std::numbers::pi);
  return q;
}

constexpr int trials = 20000;
constexpr double tolerance = 0.025;  // five times the relative noise of a standard deviation from so many trials

class UncertainArmTest : public ::testing::Test {
 protected:
  Arm erring_ = erring_arm();
  UncertaintySources sources_ = sources_of(erring_);
  UncertainArm arm_{erring_, sources_};
};

TEST_F(UncertainArmTest, PointAndLengthAgreeWithMonteCarlo) {
  const auto first = arm_.tip(posture(0));
  const auto second = arm_.tip(posture(1));
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  double square = 0.0;
  const double length = (second.in_base - first.in_base).norm();
  for (int trial = 0; trial < trials; ++trial) {
    Draw draw(erring_, sources_, trial);
    const Eigen::Vector3d p = draw.tip(posture(0));
    const Eigen::Vector3d off = p - first.in_base;
    moment += off * off.transpose() / trials;
    square += std::pow((draw.tip(posture(1)) - p).norm() - length, 2) / trials;
  }
  EXPECT_LT((moment - arm_.of_point(first)).norm(), 2.0 * tolerance * moment.norm());
  EXPECT_NEAR(arm_.of_length(first, second) / std::sqrt(square), 1.0, tolerance);
}

TEST_F(UncertainArmTest, EndsOfALengthAreCorrelated) {
  // Readings apart by next to nothing share the whole error of the parameters: only their noise is left.
  UncertaintySources silent = sources_;
  silent.encoder = silent.probing = 0.0;
  const UncertainArm arm(erring_, silent);
  const auto here = arm.tip(posture(2));
  const auto near = arm.tip(posture(2) + Eigen::VectorXd::Constant(6, 1e-3));
  EXPECT_LT(arm.of_length(here, near), 0.01 * std::sqrt(arm.of_point(here).trace()));
}

TEST_F(UncertainArmTest, DiameterAgreesWithMonteCarlo) {
  const Eigen::Vector3d centre = arm_.tip(posture(3)).in_base;
  std::vector<Eigen::VectorXd> postures;
  std::vector<UncertainTip> tips;
  RandomStream random(13, "sphere");
  while (postures.size() < 25) {
    if (const auto q =
            reach_with_joints(erring_, 0, centre + 15.7 * random.direction(), posture(100 + postures.size()))) {
      postures.push_back(*q);
      tips.push_back(arm_.tip(*q));
    }
  }
  constexpr int fits = 5000;
  double square = 0.0;
  for (int trial = 0; trial < fits; ++trial) {
    Draw draw(erring_, sources_, trial);
    Eigen::Matrix3Xd points(3, 25);
    for (int k = 0; k < 25; ++k) points.col(k) = draw.tip(postures[k]);
    const auto fitted = fit<Sphere>(points);
    ASSERT_TRUE(fitted);
    square += std::pow(2.0 * (fitted->feature.radius - draw.tip_radius()) - 25.4, 2) / fits;
  }
  EXPECT_NEAR(arm_.of_diameter(tips, centre) / std::sqrt(square), 1.0, 2.0 * tolerance);
}

TEST(UncertainArm, TheTipsRadiusCountsTwiceInADiameterAndNotInALength) {
  const Arm arm = erring_arm();
  const auto all = all_parameters(arm);
  const Parameter radius = all[find_parameter(all, "radius")];
  const UncertainArm uncertain(arm, {{radius}, Eigen::MatrixXd::Constant(1, 1, 0.003 * 0.003), 0.0, 0.0});
  std::vector<UncertainTip> tips;
  const Eigen::Vector3d centre = uncertain.tip(posture(3)).in_base;
  RandomStream random(13, "sphere");
  while (tips.size() < 9) {
    if (const auto q = reach_with_joints(arm, 0, centre + 15.7 * random.direction(), posture(100 + tips.size()))) {
      tips.push_back(uncertain.tip(*q));
    }
  }
  EXPECT_NEAR(uncertain.of_diameter(tips, centre), 0.006, 1e-15);
  EXPECT_EQ(uncertain.of_length(tips[0], tips[1]), 0.0);
}

TEST(WorkingVolume, OfProbingNoiseAloneIsTheSameEverywhere) {
  // Two ends of 3 µm each make √2 · 3 µm of any length, and a point has √3 · 3 µm.
  const UncertainArm arm(test::gao_arm(), {{}, Eigen::MatrixXd(0, 0), 0.0, 0.003});
  const WorkingVolume volume = survey(arm, {.lengths = 20, .spheres = 3, .postures = 3, .rings = 3});
  for (const auto& length : volume.lengths) {
    EXPECT_GT(length.u.count, 0) << length.length;
    EXPECT_NEAR(length.u.rms, 0.003 * std::numbers::sqrt2, 1e-12);
    EXPECT_NEAR(length.u.maximum, 0.003 * std::numbers::sqrt2, 1e-12);
    EXPECT_EQ(length.u_of_arm.maximum, 0.0);
  }
  int reached = 0;
  for (const auto& cell : volume.map) {
    if (cell.u.count > 0) {
      ++reached;
      EXPECT_NEAR(cell.u.quantile_95, 0.003 * std::numbers::sqrt3, 1e-12);
    }
  }
  EXPECT_GT(reached, 4);
  EXPECT_LT(reached, static_cast<int>(volume.map.size()));  // the corners of the map are out of reach
}

TEST(WorkingVolume, IsTheSameEveryTime) {
  const UncertainArm arm(test::gao_arm(), sources_of(test::gao_arm()));
  const VolumeSampling few{.lengths = 10, .spheres = 2, .postures = 2, .rings = 2};
  const WorkingVolume once = survey(arm, few);
  const WorkingVolume again = survey(arm, few);
  for (std::size_t i = 0; i < once.lengths.size(); ++i) EXPECT_EQ(once.lengths[i].u.rms, again.lengths[i].u.rms);
  for (std::size_t i = 0; i < once.map.size(); ++i) EXPECT_EQ(once.map[i].u.rms, again.map[i].u.rms);
  EXPECT_EQ(once.sphere_diameter.rms, again.sphere_diameter.rms);
}

}  // namespace
}  // namespace artcal
