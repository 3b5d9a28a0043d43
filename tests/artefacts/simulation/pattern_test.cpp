#include "artefacts/simulation/pattern.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "core/units.h"

namespace artcal {
namespace {

double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) / units::degree;
}

TEST(Pattern, Iso25HasItsRings) {
  RandomStream random(1, "pattern");
  PlannedProbing probing;
  probing.pattern = TouchPattern::Iso25;
  probing.pole_in_base = Eigen::Vector3d(0.3, -0.5, -0.8).normalized();
  const auto directions = directions_on_ball(probing, random);
  ASSERT_EQ(directions.size(), 25u);
  std::array<int, 5> rings{};
  for (const auto& direction : directions) {
    EXPECT_NEAR(direction.norm(), 1.0, 1e-15);
    const double polar = degrees_between(direction, probing.pole_in_base);
    EXPECT_NEAR(polar, 22.5 * std::round(polar / 22.5), 1e-9);
    ++rings[static_cast<std::size_t>(std::lround(polar / 22.5))];
  }
  EXPECT_EQ(rings, (std::array{1, 4, 8, 4, 8}));
  // Neighbours in the ring at 45° are 45° apart in azimuth, and half of that turned against the ring before.
  const auto azimuth = [&](const Eigen::Vector3d& direction) {
    const Eigen::Vector3d flat = direction - direction.dot(probing.pole_in_base) * probing.pole_in_base;
    return flat.normalized();
  };
  EXPECT_NEAR(degrees_between(azimuth(directions[5]), azimuth(directions[6])), 45.0, 1e-9);
  EXPECT_NEAR(degrees_between(azimuth(directions[1]), azimuth(directions[5])), 22.5, 1e-9);
}

TEST(Pattern, SpreadIsEvenOverTheCap) {
  RandomStream random(1, "pattern");
  PlannedProbing probing;
  probing.points = 20000;
  probing.cap = 60.0 * units::degree;
  double heights = 0.0;
  for (const auto& direction : directions_on_ball(probing, random)) {
    EXPECT_GE(direction.z(), 0.5 - 1e-12);
    heights += direction.z() / 20000;
  }
  // Archimedes: heights are uniform in [0.5, 1], mean 0.75, standard deviation of the mean 0.001.
  EXPECT_NEAR(heights, 0.75, 0.004);
}

// Five or more touches on a hemisphere never crowd so that they determine the centre poorly; drawn independently, a
// third of all sets of five touches would have a dilution above five.
TEST(Pattern, FewPointsOfASpreadDetermineTheCentre) {
  PlannedProbing probing;
  for (const int points : {5, 6, 9, 20}) {
    probing.points = points;
    for (int seed = 0; seed < 200; ++seed) {
      RandomStream random(seed, "pattern");
      EXPECT_LT(centre_dilution(directions_on_ball(probing, random)), 2.6) << points << " points, seed " << seed;
    }
  }
}

// Normal equations of pole and four at an angle t: the dilution along the pole is √(5/(5·Σz² − (Σz)²)), z the heights.
TEST(Pattern, DilutionAgreesWithTheNormalEquations) {
  for (const double polar : {20.0, 45.0, 60.0}) {
    const double t = polar * units::degree;
    std::vector<Eigen::Vector3d> directions{{0.0, 0.0, 1.0}};
    for (int i = 0; i < 4; ++i) {
      const double azimuth = 90.0 * i * units::degree;
      directions.emplace_back(std::sin(t) * std::cos(azimuth), std::sin(t) * std::sin(azimuth), std::cos(t));
    }
    const double sum = 1.0 + 4.0 * std::cos(t), squares = 1.0 + 4.0 * std::cos(t) * std::cos(t);
    EXPECT_NEAR(centre_dilution(directions), std::sqrt(5.0 / (5.0 * squares - sum * sum)), 1e-6);
  }
  EXPECT_TRUE(std::isinf(centre_dilution({{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}})));
}

TEST(Pattern, PlacesKeepToTheRectangle) {
  RandomStream random(1, "pattern");
  PlannedProbing probing;
  probing.points = 2000;
  probing.extent = {300.0, 20.0};
  Eigen::Vector2d largest = Eigen::Vector2d::Zero();
  for (const auto& place : places_on_plane(probing, random)) {
    largest = largest.cwiseMax(place.cwiseAbs());
  }
  EXPECT_LE(largest.x(), 150.0);
  EXPECT_LE(largest.y(), 10.0);
  EXPECT_GT(largest.x(), 148.0);
  EXPECT_GT(largest.y(), 9.8);
}

TEST(Pattern, RotationsLeadToTheirAxisAlsoBackwards) {
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0.6, 0, -0.8)}) {
    const Eigen::Matrix3d rotation = rotation_to(axis);
    EXPECT_LT((rotation.col(2) - axis).norm(), 1e-12);
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace artcal
