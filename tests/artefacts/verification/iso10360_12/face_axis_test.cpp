// Faces that are probed in a single point each, along an axis that other readings tell.
#include "artefacts/verification/iso10360_12/face_axis.h"
#include "core/normal_vector.h"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "artefacts/verification/iso10360_12/face_tests.h"
#include "tests/support/reported_readings.h"

namespace artcal {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using V = Eigen::Vector3d;

constexpr double length = 500.0;
constexpr double tip = 1.5;
const Rigid base_from_block{Eigen::AngleAxisd(2.1, V(0.2, -1.0, 0.5).normalized()).toRotationMatrix(),
                            {700.0, -150.0, 320.0}};

CertifiedFeature plane(const char* name, std::optional<V> normal, std::optional<V> at = std::nullopt) {
  CertifiedFeature feature;
  feature.name = name;
  feature.kind = FeatureKind::Plane;
  feature.normal = normal;
  feature.at = at;
  return feature;
}

// A gauge block along x with a 30 by 35 mm cross section.
Artefact block() {
  Artefact artefact;
  artefact.name = "block";
  artefact.type = ArtefactType::GaugeBlock;
  artefact.features = {plane("left", V(-1, 0, 0)), plane("right", V(1, 0, 0)), plane("front", V(0, -1, 0)),
                       plane("top", V(0, 0, 1))};
  artefact.distances = {{0, 1, length, 1e-4}};
  artefact.expansion_is_known = true;
  return artefact;
}

// Where the tip's centre is when it touches the block at a point, which is in the block's frame.
struct Touches {
  testing::ReportedReadings readings{tip};
  double noise = 0.0;
  RandomStream random{1, "faces"};

  void touch(const char* feature, const char* repeat, const V& at, const V& normal) {
    const V off = normal_vector(random);
    readings.add({"block", "1", feature, "", repeat}, base_from_block * (at + tip * normal) + noise * off);
  }
  // A point on each face, not opposite to each other, the second `longer` away than certified.
  void single_points(const char* repeat, double longer = 0.0) {
    touch("left", repeat, V(0, 4, -6), V(-1, 0, 0));
    touch("right", repeat, V(length + longer, -5, 3), V(1, 0, 0));
  }
  void side(const char* feature, const V& normal, const V& along, const V& across) {
    for (const auto& [a, b] : {std::pair{20.0, -12.0}, {480.0, -12.0}, {480.0, 12.0}, {20.0, 12.0}, {250.0, 3.0}}) {
      touch(feature, "align", 15.0 * normal + a * along + b * across, normal);
    }
  }
  void sides() {
    side("front", V(0, -1, 0), V(1, 0, 0), V(0, 0, 1));
    side("top", V(0, 0, 1), V(1, 0, 0), V(0, 1, 0));
  }
  [[nodiscard]] Verification evaluated(const Artefact& artefact = block(), const Specification& by = {}) const {
    const testing::SessionMaterial material(readings.recording(), {artefact}, by);
    Verification verification;
    add_face_tests(material.session(), verification);
    return verification;
  }
};

TEST(FaceAxis, SidesTellTheAxisOfSinglePoints) {
  Touches touches;
  touches.sides();
  touches.single_points("1", 0.042);
  touches.single_points("2", -0.017);
  const Verification result = touches.evaluated();
  EXPECT_THAT(result.missing, IsEmpty());
  ASSERT_EQ(result.values.size(), 2u);
  EXPECT_EQ(result.values[0].quantity, Quantity::LengthBi);
  EXPECT_NEAR(result.values[0].value, 0.042, 1e-9);
  EXPECT_NEAR(result.values[1].value, -0.017, 1e-9);
  // The distance of the points is not the length: they do not lie opposite to each other.
  EXPECT_GT(std::hypot(length, 9.0, 9.0) - length, 0.1);
}

TEST(FaceAxis, AFaceReadInSeveralPointsTellsItInEveryRepeat) {
  Touches touches;
  for (const auto& [y, z] : {std::pair{-12.0, -9.0}, {12.0, -9.0}, {0.0, 11.0}}) {
    touches.touch("left", "align", V(0, y, z), V(-1, 0, 0));
  }
  touches.single_points("1", 0.042);
  const Verification result = touches.evaluated();
  EXPECT_THAT(result.missing, IsEmpty());
  ASSERT_EQ(result.values.size(), 1u);
  EXPECT_NEAR(result.values[0].value, 0.042, 1e-9);
}

TEST(FaceAxis, SinglePointsAloneTellNone) {
  Touches touches;
  touches.noise = 0.01;  // by which the three repeats of a point scatter: no direction
  for (const char* repeat : {"1", "2", "3"}) touches.single_points(repeat);
  const Verification result = touches.evaluated();
  EXPECT_THAT(result.values, IsEmpty());
  EXPECT_THAT(result.missing, Contains(HasSubstr("are single points or lie on one line")));
}

TEST(FaceAxis, OneSideTellsNone) {
  Touches touches;
  touches.side("front", V(0, -1, 0), V(1, 0, 0), V(0, 0, 1));
  touches.single_points("1");
  EXPECT_THAT(touches.evaluated().values, IsEmpty());
}

TEST(FaceAxis, SidesThatAreNotSquareAsCertifiedAreRefused) {
  Touches touches;
  touches.side("front", V(0, -1, 0), V(1, 0, 0), V(0, 0, 1));
  const V tilted = V(0, std::sin(0.1), std::cos(0.1));
  touches.side("top", tilted, V(1, 0, 0), V(1, 0, 0).cross(tilted));
  touches.single_points("1");
  const Verification result = touches.evaluated();
  EXPECT_THAT(result.values, IsEmpty());
  EXPECT_THAT(result.missing, Contains(HasSubstr("and are certified to stand at 90.0")));
}

TEST(FaceAxis, SidesOfAnotherPlacementSayNothing) {
  Touches touches;
  touches.sides();
  touches.readings.add({"block", "2", "left", "", "1"}, base_from_block * V(-tip, 0, 0));
  touches.readings.add({"block", "2", "right", "", "1"}, base_from_block * V(length + tip, 0, 0));
  EXPECT_THAT(touches.evaluated().values, IsEmpty());
}

TEST(FaceAxis, FacesOfWhichOnlyCoordinatesAreCertifiedHaveLengthsToo) {
  Artefact gauge = block();
  gauge.type = ArtefactType::StepGauge;
  gauge.distances.clear();
  gauge.features[0].at = V(0, 0, 0);
  gauge.features[1].at = V(length, 0, 0);
  gauge.features[0].u_at = 3e-4;
  gauge.features[1].u_at = 4e-4;
  Touches touches;
  touches.sides();
  touches.single_points("1", 0.042);
  const Verification result = touches.evaluated(gauge);
  ASSERT_EQ(result.values.size(), 1u);
  EXPECT_NEAR(result.values[0].certified, length, 1e-12);
  EXPECT_NEAR(result.values[0].value, 0.042, 1e-9);
  EXPECT_NEAR(result.values[0].budget.calibration, 5e-4, 1e-12);
}

// The alignment's own part of u: the scatter of the error over many sessions in which only the sides have noise.
TEST(FaceAxis, TheAlignmentsUncertaintyBoundsThatOfTheLengths) {
  std::vector<double> errors;
  double u = 0.0;
  constexpr int sessions = 400;
  constexpr double noise = 0.05;
  for (int i = 0; i < sessions; ++i) {
    Touches touches;
    touches.random = RandomStream(2, "sessions", static_cast<std::uint64_t>(i));
    touches.noise = noise;
    touches.sides();
    touches.noise = 0.0;
    touches.touch("left", "1", V(0, 12, 0), V(-1, 0, 0));
    touches.touch("right", "1", V(length, -12, 0), V(1, 0, 0));
    const Verification result = touches.evaluated();
    ASSERT_EQ(result.values.size(), 1u);
    errors.push_back(result.values[0].value);
    u += result.values[0].budget.alignment * result.values[0].budget.alignment / sessions;
  }
  const double squares = std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0);
  const double s = std::sqrt(squares / sessions);
  // The points of a side lie at ±230 mm and 0 along the axis, at −12, −12, 12, 12 and 3 mm across it, so that by least
  // squares its slope along is known to σ/460 mm and that across to σ/√583.2 mm². The single points are 24 mm off each
  // other across, which the slope along turns into an error of the length. 3.5 % are one standard deviation.
  const double across = 24.0;
  const double along_known_to = noise / 460.0;
  EXPECT_NEAR(s / (across * along_known_to), 1.0, 0.14);
  // u takes the worst direction of both sides for that of the error, and their residuals for the noise: an upper bound.
  EXPECT_NEAR(u / std::pow(across * std::sqrt(2.0) * noise, 2) * 583.2, 1.0, 0.14);
}

}  // namespace
}  // namespace artcal
