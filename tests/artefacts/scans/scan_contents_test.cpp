// What a scan of an artefact is searched for.
#include "artefacts/scans/scan_contents.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

CertifiedFeature ball(const std::string& name, std::optional<double> radius,
                      std::optional<Eigen::Vector3d> at = std::nullopt) {
  CertifiedFeature feature;
  feature.name = name;
  feature.kind = FeatureKind::Sphere;
  feature.radius = radius;
  feature.at = at;
  return feature;
}

CertifiedFeature other(const std::string& name, FeatureKind kind) {
  CertifiedFeature feature;
  feature.name = name;
  feature.kind = kind;
  return feature;
}

TEST(ScanContents, HasSpheresAndPlanesByFeatureAtTheirTemperature) {
  Artefact artefact;
  artefact.expansion = 1e-3;
  artefact.features = {other("seat", FeatureKind::Point), ball("A", 10.0, Eigen::Vector3d(0, 0, 0)),
                       other("face", FeatureKind::Plane), ball("B", 20.0, Eigen::Vector3d(300, 400, 0)),
                       ball("C", 5.0)};
  artefact.distances = {{1, 4, 250.0, 1e-3}};
  const auto scan = scan_contents(artefact, artefact.reference_temperature + 10.0);
  ASSERT_TRUE(scan) << scan.error().text();
  EXPECT_THAT(scan->spheres, ElementsAre(1, 3, 4));
  EXPECT_THAT(scan->planes, ElementsAre(2));
  EXPECT_EQ(scan->contents.planes, 1);
  // 1e-3 per degree, ten degrees: one per cent.
  EXPECT_THAT(scan->contents.radii, ElementsAre(10.1, 20.2, 5.05));
  EXPECT_NEAR(scan->contents.distances(0, 1), 505.0, 1e-9);
  EXPECT_NEAR(scan->contents.distances(2, 0), 252.5, 1e-9);
  EXPECT_TRUE(std::isnan(scan->contents.distances(1, 2)));
}

TEST(ScanContents, RefusesWhatAScanCannotShow) {
  const auto refusal = [](std::vector<CertifiedFeature> features) {
    Artefact artefact;
    artefact.name = "bar";
    artefact.features = std::move(features);
    const auto scan = scan_contents(artefact, 20.0);
    return scan ? std::string("accepted") : scan.error().text();
  };
  EXPECT_THAT(refusal({other("seat", FeatureKind::Point)}), HasSubstr("\"bar\" has no sphere and no plane"));
  EXPECT_THAT(refusal({ball("A", std::nullopt)}),
              HasSubstr("the sphere \"A\" of the artefact \"bar\" has no diameter"));
  EXPECT_THAT(refusal({ball("A", 10.0, Eigen::Vector3d::Zero()), ball("B", 10.0, Eigen::Vector3d(15, 0, 0))}),
              HasSubstr("are 15 mm apart, less than the 20 mm"));
}

}  // namespace
}  // namespace artcal
