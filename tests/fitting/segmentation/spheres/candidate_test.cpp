// Balls of which little is lit, however densely it was scanned; and rings, pipes and cones that are no balls.
#include "fitting/segmentation/spheres/candidate.h"
#include "core/normal_vector.h"

#include <gmock/gmock.h>

#include "tests/support/lit_balls.h"

namespace artcal::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using V = Eigen::Vector3d;
constexpr double pi = 3.14159265358979323846;

struct Found {
  int balls = 0;
  double worst = 0.0;  // mm, of a centre
  int strays = 0;
};

Found found_in(const LitBalls& settings) {
  const auto result = find_spheres(scan_of(settings).points, {{settings.radius}}).value();
  Found found;
  for (const FoundSphere& sphere : result.spheres) {
    double off = settings.radius;
    for (const V& centre : settings.centres) {
      off = std::min(off, (sphere.fitted.feature.centre - centre).norm());
    }
    found.balls += off < 0.1 * settings.radius ? 1 : 0;
    found.strays += off < 0.1 * settings.radius ? 0 : 1;
    found.worst = off < 0.1 * settings.radius ? std::max(found.worst, off) : found.worst;
  }
  return found;
}

LitBalls plate_of(int rows, int columns) {
  LitBalls settings;
  settings.centres.clear();
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      settings.centres.emplace_back(83.0 * j, 83.0 * i, 150.0);
    }
  }
  return settings;
}

void with_density(LitBalls& settings, int points) {
  settings.points = points;
  settings.stem = points / 10;
  settings.plate = 4 * points;
}

// Half of the visible half, 5 % mixed pixels behind the lit rim: from 10,000 points on each ball none was found, from
// 2,500 all.
TEST(LitBalls, HalfLitAtEveryDensity) {
  for (const int points : {100, 300, 1000, 2500, 10'000, 30'000}) {
    LitBalls settings = plate_of(2, 2);
    with_density(settings, points);
    const Found found = found_in(settings);
    EXPECT_EQ(found.balls, 4) << points;
    EXPECT_EQ(found.strays, 0) << points;
    EXPECT_LT(found.worst, 1.5 / std::sqrt(points)) << points;
  }
}

TEST(LitBalls, AQuarterLitAtEveryDensity) {
  for (const int points : {100, 300, 1000, 3000, 10'000, 30'000}) {
    LitBalls settings = plate_of(2, 2);
    settings.sector = 0.5 * pi;
    with_density(settings, points);
    const Found found = found_in(settings);
    EXPECT_EQ(found.balls, 4) << points;
    EXPECT_EQ(found.strays, 0) << points;
    EXPECT_LT(found.worst, 2.0 / std::sqrt(points)) << points;
  }
}

TEST(LitBalls, AQuarterLitPlateOfTwentyFive) {
  for (const int points : {500, 4000}) {
    LitBalls settings = plate_of(5, 5);
    settings.sector = 0.5 * pi;
    settings.noise = 0.02;
    with_density(settings, points);
    const Found found = found_in(settings);
    EXPECT_EQ(found.balls, 25) << points;
    EXPECT_EQ(found.strays, 0) << points;
  }
}

// What is not taken is listed: a ball of which 2.7 % are seen.
TEST(LitBalls, WhatIsNotTakenIsListed) {
  LitBalls settings;
  settings.lowest = std::cos(0.33);
  settings.sector = 2.0 * pi;
  settings.mixed = 0.0;
  with_density(settings, 3000);
  const auto result = find_spheres(scan_of(settings).points, {{settings.radius}}).value();
  EXPECT_THAT(result.spheres, IsEmpty());
  bool said = false;
  for (const RejectedSphere& rejected : result.rejected) {
    said = said || (rejected.sphere.centre - settings.centres.front()).norm() < 0.3 * settings.radius;
    EXPECT_THAT(rejected.why, Not(IsEmpty()));
  }
  EXPECT_TRUE(said);
}

// ---- bands of other shapes ---------------------------------------------------------------------------------------

/// A band about an axis of any direction, its radius by the height; arc in rad.
template <typename RadiusAt>
Eigen::Matrix3Xd band(int count, double low, double high, double arc, double noise, const RadiusAt& radius_at) {
  RandomStream random(8, "band");
  const Eigen::Matrix3d turn = random.rotation();
  Eigen::Matrix3Xd points(3, count);
  for (auto&& p : points.colwise()) {
    const double height = random.uniform(low, high);
    const double angle = random.uniform(0.0, arc);
    const double radius = radius_at(height);
    p = V(100.0, 50.0, 80.0) + turn * V(radius * std::cos(angle), radius * std::sin(angle), height) +
        noise * normal_vector(random);
  }
  return points;
}

constexpr double r = 12.7;

template <typename RadiusAt>
void expect_no_ball(const char* name, double low, double high, const RadiusAt& radius_at) {
  for (const int count : {200, 1000, 6000}) {
    for (const double arc : {2.0 * pi, pi, 1.8}) {
      for (const double noise : {0.0, 0.01, 0.1}) {
        const auto result = find_spheres(band(count, low, high, arc, noise, radius_at), {{r}}).value();
        EXPECT_THAT(result.spheres, IsEmpty())
            << name << ", " << count << " points, arc " << arc << ", noise " << noise;
      }
    }
  }
}

TEST(NoBall, RingsAndPipesOfItsDiameter) {
  for (const double height : {3.0, 8.0, 16.0, 40.0}) {
    expect_no_ball("ring", -0.5 * height, 0.5 * height, [](double) { return r; });
  }
}

TEST(NoBall, ConesThatItTouches) {
  for (const double half_angle : {0.2, 0.5, 0.9}) {
    // Tangent to the sphere about the origin: at height h the radius is r/cos ψ - h·tan ψ.
    const auto radius_at = [&](double h) { return r / std::cos(half_angle) - h * std::tan(half_angle); };
    const double touch = r * std::sin(half_angle);
    expect_no_ball("cone", touch - 4.0, touch + 4.0, radius_at);
  }
}

TEST(NoBall, RoundedRings) {
  for (const double tube : {5.0, 8.0, 30.0}) {
    const auto radius_at = [&](double h) { return r - tube + std::sqrt(tube * tube - h * h); };
    expect_no_ball("rounded ring", -4.0, 4.0, radius_at);
  }
}

// The same band of a true ball is one: what refuses rings must not refuse it.
TEST(NoBall, ButABandOfABallIsOne) {
  for (const int count : {200, 6000}) {
    for (const double noise : {0.0, 0.01, 0.05}) {
      const auto points = band(count, -4.0, 4.0, 2.0 * pi, noise, [](double h) { return std::sqrt(r * r - h * h); });
      const auto result = find_spheres(points, {{r}}).value();
      ASSERT_EQ(result.spheres.size(), 1u)
          << count << " " << noise << (result.rejected.empty() ? "" : result.rejected.front().why);
      EXPECT_LT((result.spheres[0].fitted.feature.centre - V(100.0, 50.0, 80.0)).norm(), 0.02 + noise);
    }
  }
}

TEST(NoBall, IsSaidInWords) {
  const auto points = band(6000, -4.0, 4.0, 2.0 * pi, 0.01, [](double) { return r; });
  const auto result = find_spheres(points, {{r}}).value();
  ASSERT_FALSE(result.rejected.empty());
  EXPECT_THAT(result.rejected.front().why, HasSubstr("about (100."));
}

}  // namespace
}  // namespace artcal::testing
