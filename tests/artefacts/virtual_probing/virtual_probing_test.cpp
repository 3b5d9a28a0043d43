#include "artefacts/virtual_probing/virtual_probing.h"

#include <cmath>
#include <cstring>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/SVD>

#include "artefacts/constraints/constraint.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/random.h"
#include "tests/support/arms.h"
#include "tests/support/forward_kinematics.h"

namespace artcal {
namespace {

constexpr std::array kinds{ReadingKind::BaseCoordinates, ReadingKind::FrameCoordinates, ReadingKind::Point,
                           ReadingKind::Distance,        ReadingKind::Sphere,           ReadingKind::Length,
                           ReadingKind::Plate,           ReadingKind::UnknownSphere,    ReadingKind::Plane,
                           ReadingKind::LevelPlane};

/// Table 1's arm with a ball for a tip, off the axis.
Arm arm_with_ball() {
  Arm arm = test::gao_arm();
  arm.probes[0].tip_in_last = {3.0, -2.0, 183.5};
  arm.probes[0].radius = 3.0;
  return arm;
}

/// Where the tip of a reading is, by 4×4 matrices in long double: they know nothing of the pass.
Eigen::Vector3d tip_of(const Arm& arm, const Eigen::VectorXd& q) {
  const testing::ArmNumbers<long double> numbers(arm);
  return testing::tip_in_base(numbers, std::vector<long double>(q.begin(), q.end()), 0).cast<double>();
}

class VirtualProbingTest : public ::testing::Test {
 protected:
  void probe(ReadingKind kind) {
    options_.kind = kind;
    made_ = probe_virtually(arm_, options_);
    auto bound = build_constraints(made_.recording, made_.artefacts);
    ASSERT_TRUE(bound) << bound.error().text();
    constraints_ = std::move(*bound);
  }
  [[nodiscard]] Eigen::Vector3d tip(int reading) const { return tip_of(arm_, made_.recording.joints.col(reading)); }
  /// The readings' tips as a matrix of columns.
  [[nodiscard]] Eigen::Matrix3Xd tips(const FeatureConstraint& feature) const {
    Eigen::Matrix3Xd all(3, feature.size());
    for (int i = 0; i < feature.size(); ++i) {
      all.col(i) = tip(feature.readings[i]);
    }
    return all;
  }
  Arm arm_ = arm_with_ball();
  VirtualProbing options_{.readings = 60, .features = 3, .ball_radius = 10.0};
  VirtualRecording made_;
  Constraints constraints_;
  // The tip is put where it belongs within 1e-12 of the reach, 2 m.
  static constexpr double exact = 1e-8;
};

TEST_F(VirtualProbingTest, MakesAsManyReadingsAsAskedAndSpreadsThemEvenly) {
  for (const ReadingKind kind : kinds) {
    probe(kind);
    EXPECT_EQ(made_.recording.readings.size(), 60u);
    EXPECT_EQ(made_.recording.joints.cols(), 60);
    EXPECT_LE(made_.recording.joints.cwiseAbs().maxCoeff(), 1e3);
  }
  options_.readings = 11;
  probe(ReadingKind::Point);
  EXPECT_EQ(made_.recording.readings.size(), 11u);
  EXPECT_EQ(constraints_.features[0].size(), 4);
  EXPECT_EQ(constraints_.features[2].size(), 3);
}

TEST_F(VirtualProbingTest, TheSameSeedGivesTheSameBits) {
  for (const ReadingKind kind : kinds) {
    options_.kind = kind;
    const auto first = probe_virtually(arm_, options_);
    const auto second = probe_virtually(arm_, options_);
    ASSERT_EQ(first.recording.joints.size(), second.recording.joints.size());
    EXPECT_EQ(std::memcmp(first.recording.joints.data(), second.recording.joints.data(),
                          sizeof(double) * first.recording.joints.size()),
              0);
    VirtualProbing other = options_;
    other.seed = 2;
    EXPECT_NE(probe_virtually(arm_, other).recording.joints, first.recording.joints);
  }
}

TEST_F(VirtualProbingTest, CoordinatesInTheBaseAreWhereTheTipIs) {
  probe(ReadingKind::BaseCoordinates);
  ASSERT_EQ(constraints_.features.size(), 1u);
  EXPECT_EQ(constraints_.features[0].location, Location::Base);
  for (int i = 0; i < 60; ++i) {
    EXPECT_LT((constraints_.features[0].known[i] - tip(i)).norm(), exact);
  }
}

TEST_F(VirtualProbingTest, CoordinatesInAFrameKeepAllDistancesAndAreElsewhere) {
  probe(ReadingKind::FrameCoordinates);
  const FeatureConstraint& feature = constraints_.features[0];
  EXPECT_EQ(feature.location, Location::Posed);
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < i; ++j) {
      EXPECT_NEAR((feature.known[i] - feature.known[j]).norm(), (tip(i) - tip(j)).norm(), exact);
    }
  }
  // Not mirrored: four tips span the same signed volume.
  const auto volume = [](const auto& p) { return (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)); };
  EXPECT_NEAR(volume([&](int i) { return feature.known[i]; }) / volume([&](int i) { return tip(i); }), 1.0, 1e-9);
  EXPECT_GT((feature.known[0] - tip(0)).norm(), 1.0);
}

TEST_F(VirtualProbingTest, ReadingsOfAPointMeetInIt) {
  probe(ReadingKind::Point);
  ASSERT_EQ(constraints_.features.size(), 3u);
  for (const FeatureConstraint& feature : constraints_.features) {
    const Eigen::Matrix3Xd all = tips(feature);
    EXPECT_LT((all.colwise() - all.col(0)).colwise().norm().maxCoeff(), exact);
  }
  const double apart = (tip(0) - tip(constraints_.features[1].readings[0])).norm();
  EXPECT_GT(apart, 1.0);
}

TEST_F(VirtualProbingTest, PairsAreTheCertifiedDistanceApart) {
  for (const double length : {0.0, 300.0}) {
    options_.distance = length;
    probe(ReadingKind::Distance);
    ASSERT_EQ(constraints_.distances.size(), 30u);
    const double certified = length > 0.0 ? length : 0.25 * reach(arm_);
    for (const DistanceConstraint& distance : constraints_.distances) {
      EXPECT_EQ(distance.value, certified);
      const Eigen::Vector3d from = tip(constraints_.features[distance.first].readings[0]);
      const Eigen::Vector3d to = tip(constraints_.features[distance.second].readings[0]);
      EXPECT_NEAR((from - to).norm(), certified, exact);
    }
  }
}

// The centre is not known to the recording: it is where linear equations |P|² − 2 P·c + … = 0 have it.
TEST_F(VirtualProbingTest, ReadingsOfABallLieOnIt) {
  probe(ReadingKind::Sphere);
  for (const FeatureConstraint& feature : constraints_.features) {
    const Eigen::Matrix3Xd all = tips(feature);
    const Eigen::Matrix3Xd differences = all.rightCols(all.cols() - 1).colwise() - all.col(0);
    const Eigen::VectorXd squares = 0.5 * differences.colwise().squaredNorm().transpose();
    const Eigen::Vector3d centre = all.col(0) + differences.transpose().colPivHouseholderQr().solve(squares);
    for (int i = 0; i < feature.size(); ++i) {
      EXPECT_EQ(feature.as<OnBall>()->radius, 10.0);
      EXPECT_NEAR((all.col(i) - centre).norm(), 13.0, 10 * exact);
    }
  }
}

TEST_F(VirtualProbingTest, OfUnknownBallsTheRadiusIsNotTold) {
  probe(ReadingKind::UnknownSphere);
  for (const FeatureConstraint& feature : constraints_.features) {
    EXPECT_EQ(feature.as<OnBall>()->radius, std::nullopt);
    EXPECT_EQ(constraints_.shared.at(feature.shared_radius().value()).u, 0.0);
  }
}

TEST_F(VirtualProbingTest, ReadingsOfAPlaneLieInOneAndAreSpread) {
  for (const ReadingKind kind : {ReadingKind::Plane, ReadingKind::LevelPlane}) {
    probe(kind);
    ASSERT_EQ(constraints_.features.size(), 3u);
    for (const FeatureConstraint& feature : constraints_.features) {
      const Eigen::Matrix3Xd all = tips(feature);
      const Eigen::Matrix3Xd about = all.colwise() - Eigen::Vector3d(all.rowwise().mean());
      const Eigen::JacobiSVD<Eigen::Matrix3Xd> svd(about, Eigen::ComputeThinU);
      EXPECT_LT(svd.singularValues()[2], 10 * exact);
      EXPECT_GT(svd.singularValues()[1], 1000.0);
      EXPECT_NEAR(std::abs(svd.matrixU()(2, 2)), 1.0, kind == ReadingKind::LevelPlane ? 1e-9 : 1.0);
    }
  }
}

TEST_F(VirtualProbingTest, APlatesPointsKeepTheirDistances) {
  probe(ReadingKind::Plate);
  EXPECT_EQ(constraints_.groups.size(), 3u) << "placements";
  const FeatureConstraint& first = constraints_.features[0];
  for (const FeatureConstraint& other : constraints_.features) {
    if (other.placement == first.placement) {
      EXPECT_NEAR((tip(first.readings[0]) - tip(other.readings[0])).norm(), (first.known[0] - other.known[0]).norm(),
                  exact);
    }
  }
}

TEST_F(VirtualProbingTest, MeasuredLengthsEndInOneAnchor) {
  probe(ReadingKind::Length);
  for (const FeatureConstraint& feature : constraints_.features) {
    const std::vector<double>& lengths = feature.as<AtDistance>()->distances;
    const Eigen::Matrix3Xd all = tips(feature);
    const Eigen::Matrix3Xd differences = all.rightCols(all.cols() - 1).colwise() - all.col(0);
    Eigen::VectorXd right(differences.cols());
    for (Eigen::Index i = 0; i < right.size(); ++i) {
      const double length = lengths[i + 1];
      right[i] = 0.5 * (differences.col(i).squaredNorm() - length * length + lengths[0] * lengths[0]);
    }
    const Eigen::Vector3d anchor = all.col(0) + differences.transpose().colPivHouseholderQr().solve(right);
    for (int i = 0; i < feature.size(); ++i) {
      EXPECT_NEAR((all.col(i) - anchor).norm(), lengths[i], exact);
    }
  }
}

TEST_F(VirtualProbingTest, WhatTheArmCannotDoEndsSoon) {
  Arm two = arm_;
  two.joints.resize(2);
  options_.readings = 10'000;
  options_.kind = ReadingKind::Sphere;
  EXPECT_LT(probe_virtually(two, options_).recording.readings.size(), 10'000u) << "its tip stays on a torus";
  options_.kind = ReadingKind::Distance;
  options_.distance = 3.0 * reach(arm_);
  EXPECT_EQ(probe_virtually(arm_, options_).recording.readings.size(), 0u);
}

TEST(ReachPoint, PutsTheTipOnAnyPointWithinReachFromMostStarts) {
  const Arm arm = arm_with_ball();
  RandomStream random(7, "reach point test");
  int reached = 0;
  constexpr int tries = 200;
  for (int i = 0; i < tries; ++i) {
    Eigen::VectorXd there(6), start(6);
    for (int j = 0; j < 6; ++j) {
      there[j] = random.uniform(-std::numbers::pi, std::numbers::pi);
      start[j] = random.uniform(-std::numbers::pi, std::numbers::pi);
    }
    const Eigen::Vector3d target = tip_of(arm, there);
    if (const auto q = reach_with_joints(arm, 0, target, start)) {
      ++reached;
      EXPECT_LT((tip_of(arm, *q) - target).norm(), 1e-12 * reach(arm) + 1e-11);
    }
  }
  EXPECT_GT(reached, tries / 2);
}

TEST(ReachPoint, StaysWhereItIsWhenItIsThere) {
  const Arm arm = arm_with_ball();
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(6, -1.0, 1.5);
  const auto found = reach_with_joints(arm, 0, tip_of(arm, q), q);
  ASSERT_TRUE(found);
  EXPECT_LT((*found - q).norm(), 1e-9);
}

TEST(ReachPoint, SaysNoToAPointOutOfReach) {
  const Arm arm = arm_with_ball();
  const Eigen::VectorXd start = Eigen::VectorXd::LinSpaced(6, -1.0, 1.5);
  EXPECT_FALSE(reach_with_joints(arm, 0, Eigen::Vector3d(2.0 * reach(arm), 0.0, 0.0), start));
  EXPECT_FALSE(reach_with_joints(arm, 0, Eigen::Vector3d::Constant(std::nan("")), start));
}

}  // namespace
}  // namespace artcal
