// Five readings on a ball, nearly in one plane, fit a centre on either side of it.
#include "identification/initial/ball_sides.h"

#include <cmath>

#include <gtest/gtest.h>

#include "identification/initial/ball_start.h"

namespace artcal {
namespace {

constexpr double ball_radius = 12.7;
constexpr double tip_radius = 3.0;

// Points on a circle about the z axis at this height above a centre, as far from the centre as a tip on the ball; every
// second one off that distance by `noise`.
Eigen::Matrix3Xd ring(const Eigen::Vector3d& centre, double height, int count, double noise) {
  Eigen::Matrix3Xd points(3, count);
  for (int k = 0; k < count; ++k) {
    const double distance = ball_radius + tip_radius + (k % 2 == 0 ? noise : -noise);
    const double angle = 6.283185307179586 * k / count;
    const double aside = std::sqrt(distance * distance - height * height);
    points.col(k) = centre + Eigen::Vector3d(aside * std::cos(angle), aside * std::sin(angle), height);
  }
  return points;
}

struct Bar {
  Constraints constraints;
  std::vector<Tips> tips;
  std::vector<Eigen::Vector3d> centres, certified;
  Unknowns unknowns;

  void add(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& centre) {
    FeatureConstraint& ball = constraints.features.emplace_back();
    ball.kind = OnBall{ball_radius};
    ball.readings.resize(static_cast<std::size_t>(points.cols()));
    tips.push_back({nullptr, points, Eigen::VectorXd::Constant(points.cols(), tip_radius), {}});
    centres.push_back(centre);
    certified.push_back(centre);
  }
  void choose() {
    for (std::size_t i = 0; i < tips.size(); ++i) {
      tips[i].feature = &constraints.features[i];
    }
    choose_sides(constraints, tips, unknowns, certified, centres);
  }
};

const Eigen::Vector3d first(0, 0, 0), second(60, 0, 400);
constexpr double height = 8.0;

// The second ball's centre was found on the wrong side of its readings, 16 mm away.
Bar wrong_side(double noise) {
  Bar bar;
  bar.add(ring(first, -5.0, 9, noise), first);
  bar.add(ring(second, height, 5, noise), second + Eigen::Vector3d(0, 0, 2 * height));
  bar.constraints.distances.push_back({0, 1, (second - first).norm(), 1e-3});
  return bar;
}

TEST(BallSides, TheOtherSideIsTheMirrorImage) {
  const Eigen::Matrix3Xd points = ring(second, height, 5, 0.0);
  const auto other = point_on_the_other_side(points, Eigen::VectorXd::Constant(5, ball_radius + tip_radius), second);
  ASSERT_TRUE(other);
  EXPECT_LT((*other - second - Eigen::Vector3d(0, 0, 2 * height)).norm(), 1e-9);
}

TEST(BallSides, CertifiedDistancesDecideWhereReadingsDoNot) {
  Bar bar = wrong_side(0.01);
  bar.choose();
  EXPECT_LT((bar.centres[1] - second).norm(), 0.1);
}

TEST(BallSides, CertifiedCoordinatesDecideToo) {
  Bar bar = wrong_side(0.01);
  bar.constraints.distances.clear();
  bar.constraints.features[1].location = Location::Posed;
  bar.certified[1] = second + Eigen::Vector3d(0, 0, 1.0);
  bar.choose();
  EXPECT_LT((bar.centres[1] - second).norm(), 0.1);
}

// A reading a millimetre out of the plane says on which side the centre is, whatever a certificate says.
TEST(BallSides, ReadingsThatDecideStand) {
  Bar bar = wrong_side(0.01);
  const double distance = ball_radius + tip_radius;
  const double higher = height + 3.0;
  bar.tips[1].centres.col(0) = second + Eigen::Vector3d(std::sqrt(distance * distance - higher * higher), 0, higher);
  bar.centres[1] = second;
  bar.constraints.distances[0].value = (second + Eigen::Vector3d(0, 0, 2 * height) - first).norm();
  bar.choose();
  EXPECT_LT((bar.centres[1] - second).norm(), 1e-9);
}

}  // namespace
}  // namespace artcal
