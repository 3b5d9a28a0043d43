#include "artefacts/artefact/consistency.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

CertifiedFeature ball(const std::string& name, const std::optional<Eigen::Vector3d>& at = {}, double radius = 10.0) {
  CertifiedFeature feature;
  feature.name = name;
  feature.kind = FeatureKind::Sphere;
  feature.at = at;
  feature.radius = radius;
  return feature;
}

CertifiedFeature face(const std::string& name, double x, const Eigen::Vector3d& normal) {
  CertifiedFeature feature;
  feature.name = name;
  feature.kind = FeatureKind::Plane;
  feature.at = Eigen::Vector3d(x, 5.0, -7.0 * x);
  feature.normal = normal;
  return feature;
}

// Balls on a line, 100 mm apart; unknown places.
Artefact bar(int balls) {
  Artefact artefact;
  for (int i = 0; i < balls; ++i) {
    artefact.features.push_back(ball(std::to_string(i + 1)));
  }
  return artefact;
}

std::string message(const Artefact& artefact) {
  const auto found = find_contradiction(artefact);
  return found ? found->message : "none";
}

TEST(Consistency, OfDistancesAlongAStraightBarHolds) {
  Artefact artefact = bar(4);
  artefact.distances = {{0, 1, 100.0, 0.001}, {1, 2, 100.0, 0.001}, {2, 3, 100.0, 0.001}, {0, 3, 300.0, 0.001}};
  EXPECT_EQ(message(artefact), "none");
  // The way round has u = 1.73 µm, the distance 1 µm: 2·√4 = 4 µm is the bound.
  artefact.distances[3].value = 300.0039;
  EXPECT_EQ(message(artefact), "none");
  artefact.distances[3].value = 299.0;
  EXPECT_EQ(message(artefact), "none") << "a bent bar";
}

TEST(Consistency, OfADistanceLongerThanTheWayRoundIsRefused) {
  Artefact artefact = bar(4);
  artefact.distances = {{0, 1, 100.0, 0.001}, {2, 1, 100.0, 0.001}, {2, 3, 100.0, 0.001}, {0, 3, 300.0041, 0.001}};
  EXPECT_THAT(message(artefact),
              HasSubstr("between \"1\" and \"4\" is 300.0041 mm, but the other distances lead from one "
                        "to the other in 300 mm"));
  EXPECT_EQ(find_contradiction(artefact)->of, Contradiction::Of::Distance);
  EXPECT_EQ(find_contradiction(artefact)->index, 3);
}

TEST(Consistency, OfADistanceStatedTwiceIsRefused) {
  Artefact artefact = bar(2);
  artefact.distances = {{0, 1, 100.0, 0.001}, {1, 0, 100.0, 0.001}};
  EXPECT_THAT(message(artefact), HasSubstr("between \"2\" and \"1\" is stated twice"));
}

TEST(Consistency, CountsTheUncertaintyOfCoordinates) {
  Artefact artefact;
  artefact.features = {ball("1", Eigen::Vector3d::Zero()), ball("2", Eigen::Vector3d(0, 60, 80))};
  artefact.distances = {{0, 1, 100.0025, 0.001}};
  EXPECT_THAT(message(artefact), HasSubstr("is 100.0025 mm, but their certified coordinates are 100 mm apart"));
  artefact.features[0].u_at = artefact.features[1].u_at = 0.0006;  // together 1.31 µm
  EXPECT_EQ(message(artefact), "none");
}

TEST(Consistency, OfBallsThatOverlapIsRefused) {
  Artefact artefact;
  artefact.features = {ball("1", Eigen::Vector3d::Zero()), ball("2", Eigen::Vector3d(0, 0, 19.9))};
  EXPECT_THAT(message(artefact), HasSubstr("the balls \"1\" and \"2\" overlap: their centres are 19.9 mm apart"));
  artefact.features[1].radius.reset();
  EXPECT_EQ(message(artefact), "none") << "a ball of unknown size may be small";
  Artefact pair = bar(2);
  pair.distances = {{0, 1, 19.9, 0.001}};
  EXPECT_THAT(message(pair), HasSubstr("overlap: the certified distance is 19.9 mm, their radii together are 20 mm"));
}

TEST(Consistency, OfTwoFeaturesInOnePlaceIsRefused) {
  Artefact artefact;
  artefact.features = {ball("1", Eigen::Vector3d(1, 2, 3)), ball("2"), ball("3", Eigen::Vector3d(1, 2, 3))};
  EXPECT_THAT(message(artefact), HasSubstr("the features \"1\" and \"3\" are in the same place"));
  EXPECT_EQ(find_contradiction(artefact)->index, 2);
}

TEST(Consistency, OfPlanesIsTakenAlongTheirNormal) {
  Artefact artefact;
  artefact.features = {face("1", 0.0, -Eigen::Vector3d::UnitX()), face("2", 20.0, Eigen::Vector3d::UnitX())};
  artefact.distances = {{0, 1, 20.0, 0.001}};
  EXPECT_EQ(message(artefact), "none") << "points of planes may lie anywhere in them";
  artefact.distances[0].value = 20.003;
  EXPECT_THAT(message(artefact), HasSubstr("their certified coordinates are 20 mm apart"));
  artefact.distances[0].value = 20.0;
  artefact.features[1].normal = Eigen::Vector3d(1.0, 5e-5, 0.0).normalized();
  EXPECT_EQ(message(artefact), "none") << "ten arc seconds are how well normals are certified";
  artefact.features[1].normal = Eigen::Vector3d(1.0, 5e-4, 0.0).normalized();
  EXPECT_THAT(message(artefact), HasSubstr("the planes \"1\" and \"2\" are not parallel"));
  artefact.features[1].normal = Eigen::Vector3d(1.0, 0.01, 0.0).normalized();
  EXPECT_THAT(message(artefact), HasSubstr("the planes \"1\" and \"2\" are not parallel"));
}

// 300 distances of a plate, each measured with its own u: one in twenty differs from the coordinates by more than 2 u.
TEST(Consistency, OfManyDistancesAllowsForTheirNumber) {
  RandomStream random(3, "certificate");
  Artefact plate;
  for (int i = 0; i < 25; ++i) {
    plate.features.push_back(ball(std::to_string(i), Eigen::Vector3d(100.0 * (i % 5), 100.0 * (i / 5), 0.0)));
  }
  for (int i = 0; i < 25; ++i) {
    for (int j = i + 1; j < 25; ++j) {
      const double distance = (*plate.features[j].at - *plate.features[i].at).norm();
      plate.distances.push_back({i, j, distance + 0.001 * random.normal(), 0.001});
    }
  }
  EXPECT_EQ(message(plate), "none");
  plate.distances[120].value += 0.006;
  EXPECT_THAT(message(plate), HasSubstr("their certified coordinates are"));
}

TEST(Consistency, OfATypeWithOtherFeaturesIsRefused) {
  Artefact artefact = bar(3);
  artefact.type = ArtefactType::BallBar;
  EXPECT_EQ(message(artefact), "none");
  artefact.features[1].kind = FeatureKind::Plane;
  EXPECT_THAT(message(artefact), HasSubstr("the artefact is a ball bar, which has spheres or points, but the feature "
                                           "\"2\" is none"));
  artefact = bar(1);
  artefact.type = ArtefactType::BallBar;
  EXPECT_THAT(message(artefact), HasSubstr("is a ball bar and has 1 features, expected at least 2"));
  artefact = bar(2);
  artefact.type = ArtefactType::Sphere;
  EXPECT_THAT(message(artefact), HasSubstr("is a sphere and has 2 features, expected 1"));
}

// All pairs of 60 balls: 1770 distances, in a moment.
TEST(Consistency, FindsTheOneWrongDistanceAmongMany) {
  Artefact artefact;
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 60; ++i) {
    places.emplace_back(97.0 * (i % 8), 89.0 * (i / 8), 3.0 * ((i * 7) % 5));
    artefact.features.push_back(ball(std::to_string(i)));
    for (int j = 0; j < i; ++j) {
      artefact.distances.push_back({j, i, (places[j] - places[i]).norm(), 0.001});
    }
  }
  EXPECT_EQ(message(artefact), "none");
  artefact.distances[900].value *= 1.5;
  EXPECT_NE(message(artefact), "none");
}

}  // namespace
}  // namespace artcal
