#include "artefacts/verification/sphere_plate/sphere_plate.h"

#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "artefacts/verification/sphere_plate/rigid_fit.h"
#include "tests/support/reported_readings.h"

namespace artcal {
namespace {

using testing::ball;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string name_at(int row, int column) { return fmt::format("{}{}", static_cast<char>('A' + row), column + 1); }

// 5 × 5 balls, 100 mm apart but for some µm, as a real plate is.
Artefact plate_5x5(double irregularity = 0.030) {
  RandomStream random(11, "plate");
  Artefact plate;
  plate.name = "plate";
  plate.expansion = 11.5e-6;
  plate.u_expansion = 0.2e-6;
  plate.expansion_is_known = true;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) {
      CertifiedFeature feature = ball(name_at(row, column), 22.0);
      feature.at = Eigen::Vector3d(100.0 * column, 100.0 * row, 0.0) +
                   irregularity * Eigen::Vector3d{random.normal(), random.normal(), 0.3 * random.normal()};
      feature.u_at = 0.3e-3;
      plate.features.push_back(feature);
    }
  }
  return plate;
}

struct Case {
  Artefact artefact = plate_5x5();
  double noise = 0.0015;  ///< of a reading
  double scale = 1.0;
  double temperature = 20.0;
  std::function<std::string(int)> name_of = [this](int i) { return artefact.features[i].name; };  ///< empty: not read
  std::function<Eigen::Vector3d(int)> error = [](int) { return Eigen::Vector3d::Zero(); };
  std::function<Rigid(int)> base_from_plate = [](int) {
    return Rigid{Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 0.5).normalized()).toRotationMatrix(),
                 {400.0, -200.0, 300.0}};
  };
  std::uint64_t seed = 1;

  [[nodiscard]] PlateVerification verified() const {
    testing::ReportedReadings readings;
    RandomStream random(seed, "plate readings");
    for (int i = 0; i < static_cast<int>(artefact.features.size()); ++i) {
      if (name_of(i).empty()) continue;
      const double expansion_factor = std::isfinite(temperature) ? artefact.expansion_factor(temperature) : 1.0;
      const Eigen::Vector3d centre =
          base_from_plate(i) * Eigen::Vector3d(expansion_factor * (*artefact.features[i].at + error(i)));
      readings.touch_ball({"plate", "P1", name_of(i), "", ""}, scale * centre, 11.0, testing::pattern_25(), noise,
                          random, temperature);
    }
    Specification by;
    by.limits = {{Quantity::LengthUni, {0.015, 0.0, {}}}};
    by.u_temperature = 0.05;
    by.plan = TestPlan{};
    const testing::SessionMaterial material(readings.recording(), {artefact}, by);
    return verify_sphere_plate(material.session()).value();
  }
};

// Rotation and shift found again, and no scale taken in.
TEST(RigidFit, FindsThePlantedMotion) {
  RandomStream random(2, "motions");
  for (int n : {3, 4, 25}) {
    const Rigid to_from{random.rotation(), 100.0 * random.direction()};
    Eigen::Matrix3Xd from = 200.0 * Eigen::Matrix3Xd::NullaryExpr(3, n, [&] { return random.normal(); });
    const Eigen::Matrix3Xd to = (to_from.rotation * (1.001 * from)).colwise() + to_from.translation;
    const auto fit = fit_rigid(to, from);
    ASSERT_TRUE(fit);
    EXPECT_NEAR((fit->to_from.rotation - to_from.rotation).norm(), 0.0, 1e-12);
    EXPECT_NEAR(fit->to_from.rotation.determinant(), 1.0, 1e-12);
    EXPECT_NEAR(fit->scale, 1e-3, 1e-12);
  }
}

TEST(RigidFit, WeightsCount) {
  Eigen::Matrix3Xd from(3, 4);
  from << 0.0, 100.0, 0.0, 50.0, 0.0, 0.0, 100.0, 50.0, 0.0, 0.0, 0.0, 30.0;
  Eigen::Matrix3Xd to = from;
  to.col(3).z() += 1.0;
  const auto heavy = fit_rigid(to, from, Eigen::Vector4d(1.0, 1.0, 1.0, 1e9));
  const auto light = fit_rigid(to, from, Eigen::Vector4d(1.0, 1.0, 1.0, 1e-9));
  EXPECT_LT(heavy->residuals.col(3).norm(), 1e-6);
  EXPECT_NEAR(light->residuals.col(3).norm(), 1.0, 1e-6);
}

TEST(RigidFit, RefusesWhatTellsNoPose) {
  Eigen::Matrix3Xd line(3, 4);
  line << 0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0;
  EXPECT_THAT(fit_rigid(line, line).error().message, HasSubstr("on one line"));
  EXPECT_FALSE(fit_rigid(line.leftCols(2), line.leftCols(2)));
}

TEST(SpherePlate, AGoodPlateConforms) {
  const PlateVerification result = Case{}.verified();
  EXPECT_EQ(result.verification.conclusion, Conclusion::ConformityProven);
  EXPECT_THAT(result.verification.missing, IsEmpty());
  EXPECT_THAT(result.verification.warnings, IsEmpty());
  EXPECT_EQ(result.verification.values.size(), 300u);
  ASSERT_EQ(result.placements.size(), 1u);
  EXPECT_LT(result.placements[0].rms, 0.0015);
  EXPECT_LT(result.placements[0].en_worst, 2.5);
}

TEST(SpherePlate, OneBallOffByTenMicrometresIsNamed) {
  Case planted;
  planted.error = [](int i) { return i == 7 ? Eigen::Vector3d(0.006, -0.008, 0.0) : Eigen::Vector3d::Zero(); };
  const PlateVerification result = planted.verified();
  EXPECT_THAT(result.verification.warnings, ::testing::ElementsAre(HasSubstr("ball \"B3\" is off by")));
  int stand_out = 0;
  for (const BallResidual& ball : result.placements[0].balls) {
    stand_out += ball.is_outlier ? 1 : 0;
    EXPECT_EQ(ball.is_outlier, ball.feature == "B3") << ball.standardised;
  }
  // 24/25 of it stays in the residual: the pose follows a little.
  EXPECT_NEAR(result.placements[0].balls[7].residual_in_plate.x(), 0.006, 0.0015);
  EXPECT_NEAR(result.placements[0].balls[7].residual_in_plate.y(), -0.008, 0.0015);
}

// The chance of naming a good ball is one in a hundred plates.
TEST(SpherePlate, GoodBallsAreSeldomNamed) {
  int named = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Case planted;
    planted.seed = seed;
    named += planted.verified().verification.warnings.empty() ? 0 : 1;
  }
  EXPECT_LE(named, 7);  // 2 expected
}

TEST(SpherePlate, AScaleErrorOfFivePpmComesOutWithinItsUncertainty) {
  double sum = 0.0, chi_squared = 0.0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Case planted;
    planted.scale = 1.0 + 5e-6;
    planted.seed = seed;
    planted.artefact.u_expansion = 0.0;  // at 20 °C it would not count
    const PlatePlacement plate = planted.verified().placements[0];
    sum += plate.scale / 50;
    chi_squared += std::pow((plate.scale - 5e-6) / plate.u_scale, 2);
    EXPECT_LT(plate.u_scale, 1.5e-6);
  }
  EXPECT_NEAR(sum, 5e-6, 0.3e-6);
  EXPECT_LT(chi_squared, 100.0);  // u also holds certificate and thermometer, which nothing disturbs here
}

TEST(SpherePlate, TemperatureIsCompensated) {
  Case planted;
  planted.temperature = 24.0;
  const PlateVerification result = planted.verified();
  EXPECT_NEAR(result.placements[0].scale, 0.0, 4.0 * result.placements[0].u_scale);
  planted.temperature = std::nan("");
  EXPECT_THAT(planted.verified().verification.missing, Contains(HasSubstr("temperature was not read")));
}

TEST(SpherePlate, AnotherOrderIsFoundAndNotHeldAgainstTheArm) {
  Case swapped;
  swapped.name_of = [&](int i) { return swapped.artefact.features[i == 3 ? 17 : i == 17 ? 3 : i].name; };
  const PlateVerification result = swapped.verified();
  EXPECT_THAT(result.placements[0].finding, HasSubstr("another order"));
  EXPECT_THAT(result.placements[0].finding, HasSubstr("A4 is D3, D3 is A4"));
  EXPECT_EQ(result.verification.conclusion, Conclusion::ConformityNotShown);
  // Turned by a quarter: the square looks the same, but for its irregularity of 30 µm.
  Case turned;
  turned.name_of = [](int i) { return name_at(i % 5, 4 - i / 5); };
  EXPECT_THAT(turned.verified().placements[0].finding, HasSubstr("another order"));
}

TEST(SpherePlate, MirroredNumberingIsFound) {
  Case mirrored;
  mirrored.name_of = [](int i) { return name_at(i / 5, 4 - i % 5); };
  const PlateVerification result = mirrored.verified();
  EXPECT_THAT(result.placements[0].finding, HasSubstr("numbering is mirrored"));
  EXPECT_EQ(result.verification.conclusion, Conclusion::ConformityNotShown);
}

// A pattern with depth, whose certificate counts one axis the other way round.
TEST(SpherePlate, AMirroredPatternInSpaceIsFound) {
  Case deep;
  for (std::size_t i = 0; i < deep.artefact.features.size(); ++i) {
    deep.artefact.features[i].at->z() += 30.0 * static_cast<double>(i % 3);
  }
  Case wrong = deep;
  wrong.name_of = [&](int i) { return wrong.artefact.features[i].name; };
  wrong.error = [&](int i) { return Eigen::Vector3d(0.0, 0.0, -2.0 * wrong.artefact.features[i].at->z()); };
  deep.name_of = wrong.name_of;
  EXPECT_EQ(deep.verified().placements[0].finding, "");
  EXPECT_THAT(wrong.verified().placements[0].finding, HasSubstr("its mirror image fits"));
}

TEST(SpherePlate, MissingBallsAreNamed) {
  Case planted;
  planted.name_of = [&](int i) { return i == 5 || i == 24 ? "" : planted.artefact.features[i].name; };
  const PlateVerification result = planted.verified();
  EXPECT_THAT(result.placements[0].not_measured, ::testing::ElementsAre("B1", "E5"));
  EXPECT_THAT(result.verification.missing, Contains(HasSubstr("not measured: B1, E5")));
  EXPECT_EQ(result.verification.conclusion, Conclusion::ConformityNotShown);
  EXPECT_EQ(result.verification.values.size(), 23u * 22u / 2u);
}

TEST(SpherePlate, TwoPosesUnderOneNameAreFound) {
  Case planted;
  planted.base_from_plate = [](int i) {
    const double angle = i < 15 ? 0.0 : 0.3;
    return Rigid{Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix(),
                 {i < 15 ? 400.0 : 900.0, 100.0, 0.0}};
  };
  const PlateVerification result = planted.verified();
  EXPECT_THAT(result.placements[0].finding, HasSubstr("two poses under one placement name"));
  EXPECT_THAT(result.placements[0].finding, HasSubstr("D1, D2, D3, D4, D5, E1"));
  EXPECT_EQ(result.verification.conclusion, Conclusion::ConformityNotShown);
}

// The first placement misses a ball; the four after it are complete.
TEST(SpherePlate, AnIncompletePlacementHasNoPartInTheSwingRound) {
  const Artefact plate = plate_5x5();
  testing::ReportedReadings readings;
  RandomStream random(3, "swing-round");
  for (int placement = 0; placement < 5; ++placement) {
    const Rigid base_from_plate{
        Eigen::AngleAxisd(placement * std::numbers::pi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix(),
        {500.0, 100.0, 200.0}};
    for (int i = placement == 0 ? 1 : 0; i < 25; ++i) {
      const auto& feature = plate.features[static_cast<std::size_t>(i)];
      readings.touch_ball({"plate", std::to_string(placement), feature.name, "", ""}, base_from_plate * *feature.at,
                          11.0, testing::pattern_25(), 0.001, random);
    }
  }
  const testing::SessionMaterial material(readings.recording(), {plate}, {});
  const auto result = verify_sphere_plate(material.session());
  ASSERT_TRUE(result);
  ASSERT_EQ(result->calibrations.size(), 1u);
  EXPECT_EQ(result->calibrations[0].placements, 4);
  ASSERT_EQ(result->calibrations[0].centres.cols(), 25);
  EXPECT_LT(result->calibrations[0].deviations.cwiseAbs().maxCoeff(), 0.003);
}

}  // namespace
}  // namespace artcal
