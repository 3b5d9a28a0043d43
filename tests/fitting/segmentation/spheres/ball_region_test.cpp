#include "fitting/segmentation/spheres/ball_region.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "core/random.h"

namespace artcal {
namespace {

using ::testing::IsEmpty;
using V = Eigen::Vector3d;

constexpr double radius = 15.7;
const V centre(300.0, -250.0, 410.0);

enum On { ball, stem, table, stray };

/// Points around a ball and what they are on; its stem goes down, against z.
struct Scene {
  std::vector<V> points;
  std::vector<On> labels;
  RandomStream random{7, "ball region"};

  void add(const V& at, On label) {
    points.push_back(centre + at);
    labels.push_back(label);
  }
  // On the ball down to the height `lowest` (times R), with normal noise along the radius.
  void scan_ball(int count, double noise, double lowest) {
    while (count > 0) {
      const V direction = random.direction();
      if (direction.z() >= lowest) {
        add((radius + noise * random.normal()) * direction, ball);
        --count;
      }
    }
  }
  void scan_stem(int count, double stem_radius) {
    for (int i = 0; i < count; ++i) {
      const double turn = random.uniform(0.0, 6.2832);
      const double begin = std::sqrt(radius * radius - stem_radius * stem_radius);
      add({stem_radius * std::cos(turn), stem_radius * std::sin(turn), -random.uniform(begin, 2.5 * radius)}, stem);
    }
  }
  void scan_table(int count) {
    for (int i = 0; i < count; ++i) {
      add({random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0), -radius}, table);
    }
  }
  [[nodiscard]] BallRegion region() const {
    Eigen::Matrix3Xd all(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = points[i];
    return ball_region(all, Sphere{centre, radius});
  }
  [[nodiscard]] int of(const BallRegion& region, On label) const {
    return static_cast<int>(std::count_if(region.points.begin(), region.points.end(),
                                          [&](int i) { return labels[static_cast<std::size_t>(i)] == label; }));
  }
};

// Root mean square of the distances from the true sphere.
double scatter(const Scene& scene, const std::vector<int>& which) {
  double sum = 0.0;
  for (const int i : which) {
    const double off = (scene.points[static_cast<std::size_t>(i)] - centre).norm() - radius;
    sum += off * off / static_cast<double>(which.size());
  }
  return std::sqrt(sum);
}

TEST(BallRegion, TakesEveryPointWhateverTheNoise) {
  for (const double noise : {0.001, 0.01, 0.1, 0.3}) {
    Scene scene;
    scene.scan_ball(4000, noise, -0.8);
    const BallRegion region = scene.region();
    EXPECT_EQ(region.points.size(), 4000u) << noise;
    EXPECT_TRUE(region.is_clear()) << noise;
    EXPECT_NEAR(region.share, 0.9, 0.06) << noise;
  }
}

TEST(BallRegion, SaysHowMuchOfTheBallWasSeenOfSparseScansToo) {
  for (const int points : {300, 3000}) {
    Scene scene;
    scene.scan_ball(points, 0.01, 0.0);
    EXPECT_NEAR(scene.region().share, 0.5, 0.1) << points;
  }
}

TEST(BallRegion, TheStemIsNoPartOfItAndTheScatterStaysWhole) {
  for (const double noise : {0.001, 0.01, 0.1, 0.3}) {
    Scene scene;
    scene.scan_ball(4000, noise, -0.85);
    scene.scan_stem(300, 7.2);
    const BallRegion region = scene.region();
    EXPECT_EQ(scene.of(region, stem), 0) << noise;
    EXPECT_GT(scene.of(region, ball), 3500) << noise;
    EXPECT_NEAR(scatter(scene, region.points), noise, 0.03 * noise);
    EXPECT_TRUE(region.is_clear());
  }
}

TEST(BallRegion, ATableThatTheBallLiesOnIsNoPartOfIt) {
  Scene scene;
  scene.scan_ball(4000, 0.02, -1.0);
  scene.scan_table(3000);
  const BallRegion region = scene.region();
  EXPECT_EQ(scene.of(region, table),
            0);  // not where it comes near to the ball either, inside the ring of foreign points
  EXPECT_GT(scene.of(region, ball), 2000);
}

TEST(BallRegion, ATipOnItsWayIsNoPartOfIt) {
  Scene scene;
  scene.scan_ball(4000, 0.02, -0.5);
  const V from = V(1.0, 1.0, 1.0).normalized();
  for (int i = 0; i < 60; ++i) scene.add((radius + 0.05 + 0.5 * i) * from, stray);
  const BallRegion region = scene.region();
  EXPECT_EQ(scene.of(region, stray), 0);
  EXPECT_GT(scene.of(region, ball), 3500);
}

TEST(BallRegion, NoiseAsWideAsTheBandIsNotClear) {
  for (const double share : {0.03, 0.05, 0.1}) {
    Scene scene;
    scene.scan_ball(4000, share * radius, -0.5);
    EXPECT_FALSE(scene.region().is_clear()) << share;
  }
}

TEST(BallRegion, WhatIsMostlyBesideForeignPointsIsNotClear) {
  Scene scene;
  scene.scan_ball(4000, 0.01, -0.5);
  for (int i = 0; i < 300; ++i) scene.add(1.2 * radius * scene.random.direction(), stray);
  const BallRegion region = scene.region();
  EXPECT_FALSE(region.is_clear());
  EXPECT_GT(region.beside_foreign, 2000);
}

TEST(BallRegion, SingleContactsHangTogether) {
  Scene scene;  // a spiral of 40 points over the upper half
  for (int i = 0; i < 40; ++i) {
    const double z = 1.0 - (i + 0.5) / 40.0;
    const double turn = 2.39996 * i;
    scene.add(radius * V(std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z), ball);
  }
  EXPECT_EQ(scene.region().points.size(), 40u);
}

TEST(BallRegion, NothingThereIsNothing) {
  Scene scene;
  scene.add({40.0, 0.0, 0.0}, stray);
  EXPECT_THAT(scene.region().points, IsEmpty());
}

}  // namespace
}  // namespace artcal
