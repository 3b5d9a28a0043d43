#include "artefacts/verification/iso10360_12/face_tests.h"

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "tests/support/reported_readings.h"

namespace artcal {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

CertifiedFeature face(const char* name, double x, double looks) {
  CertifiedFeature feature;
  feature.name = name;
  feature.kind = FeatureKind::Plane;
  feature.at = Eigen::Vector3d(x, 0.0, 0.0);
  feature.normal = Eigen::Vector3d(looks, 0.0, 0.0);
  return feature;
}

// A step gauge: a block of 20 mm, a gap of 20 mm, a block of 20 mm.
Artefact step_gauge() {
  Artefact gauge;
  gauge.name = "gauge";
  gauge.type = ArtefactType::StepGauge;
  gauge.features = {face("1", 0.0, -1.0), face("2", 20.0, 1.0), face("3", 40.0, -1.0), face("4", 60.0, 1.0)};
  gauge.distances = {{0, 1, 20.0, 1e-4}, {0, 2, 40.0, 1e-4}, {1, 2, 20.0, 1e-4}, {0, 3, 60.0, 1e-4}};
  gauge.expansion_is_known = true;
  return gauge;
}

Verification measured(const Artefact& gauge, double scale, bool on_one_line = false) {
  testing::ReportedReadings readings(1.5);
  const Rigid base_from_gauge{Eigen::AngleAxisd(0.8, Eigen::Vector3d(1.0, 1.0, 0.3).normalized()).toRotationMatrix(),
                              {300.0, 200.0, 100.0}};
  for (std::size_t i = 0; i < gauge.features.size(); ++i) {
    const double x = 20.0 * static_cast<double>(i);
    const double looks = i % 2 == 0 ? -1.0 : 1.0;
    for (const auto& [y, z] : {std::pair{-4.0, -3.0}, {4.0, -3.0}, {0.0, 5.0}}) {
      readings.add({"gauge", "1", gauge.features[i].name, "", ""},
                   scale * (base_from_gauge * Eigen::Vector3d(x + 1.5 * looks, y, on_one_line ? 0.0 : z)));
    }
  }
  const testing::SessionMaterial material(readings.recording(), {gauge}, {});
  Verification verification;
  add_face_tests(material.session(), verification);
  return verification;
}

TEST(FaceTests, TheTipComesOffAsTheFacesLook) {
  const Verification result = measured(step_gauge(), 1.0);
  ASSERT_EQ(result.values.size(), 4u);
  const std::vector<Quantity> kinds{Quantity::LengthBi, Quantity::LengthUni, Quantity::LengthBi, Quantity::LengthBi};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(result.values[i].value, 0.0, 1e-9) << i;
    EXPECT_EQ(result.values[i].quantity, kinds[i]) << i;
  }
}

TEST(FaceTests, AnErrorComesOut) {
  // Scaled with the tip: 60 mm and two radii of 1.5 mm grow by 0.1 %.
  EXPECT_NEAR(measured(step_gauge(), 1.001).values[3].value, 0.063, 1e-9);
}

TEST(FaceTests, AGaugeBlockNeedsNoNormals) {
  Artefact block = step_gauge();
  block.features.resize(2);
  block.distances.resize(1);
  for (auto& feature : block.features) {
    feature.normal.reset();
    feature.at.reset();
  }
  EXPECT_THAT(measured(block, 1.0).missing, Contains(HasSubstr("does not say which way the faces look")));
  block.type = ArtefactType::GaugeBlock;
  EXPECT_NEAR(measured(block, 1.0).values[0].value, 0.0, 1e-9);
}

TEST(FaceTests, ReadingsOnOneLineTellNoDirection) {
  const Verification result = measured(step_gauge(), 1.0, true);
  EXPECT_TRUE(result.values.empty());
  EXPECT_THAT(result.missing, Contains(HasSubstr("lie on one line")));
}

}  // namespace
}  // namespace artcal
