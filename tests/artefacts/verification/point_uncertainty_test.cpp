#include "artefacts/verification/point_uncertainty.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "artefacts/verification/iso10360_12/iso10360_12.h"
#include "tests/support/reported_readings.h"

namespace artcal {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Directions = std::vector<Eigen::Vector3d>;

// The pole and four at an angle (degrees) from it, about an axis.
Directions cross(double polar, const Eigen::Vector3d& axis) {
  const double angle = polar * std::numbers::pi / 180.0;
  const Eigen::Vector3d across = axis.unitOrthogonal();
  const Eigen::Vector3d third = axis.cross(across);
  Directions directions{axis};
  for (const Eigen::Vector3d& side : {across, third, Eigen::Vector3d(-across), Eigen::Vector3d(-third)}) {
    directions.emplace_back(std::cos(angle) * axis + std::sin(angle) * side);
  }
  return directions;
}

// Normal equations of a sphere of free radius: the distance of a touch changes by -n·dc - dr.
Eigen::Matrix4d inverse_normal_matrix(const Directions& directions) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  for (const Eigen::Vector3d& n : directions) {
    const Eigen::Vector4d row(n.x(), n.y(), n.z(), 1.0);
    normal += row * row.transpose();
  }
  return normal.inverse();
}

Artefact bar_of_two() {
  Artefact bar;
  bar.name = "bar";
  bar.features = {testing::ball("A", 25.0), testing::ball("B", 25.0)};
  bar.distances = {{0, 1, 500.0, 0.2e-3}};
  bar.expansion_is_known = true;
  bar.expansion = 1e-6;
  bar.u_expansion = 1e-7;
  return bar;
}

Specification by_limit(double limit) {
  Specification by;
  by.limits = {{Quantity::LengthUni, {limit, 0.0, {}}}};
  by.u_temperature = 0.1;
  by.plan = TestPlan{};
  return by;
}

// `placements` times the bar along x, touched along these directions.
Verification of_bar(const Directions& directions, int placements, double noise, const Specification& by) {
  testing::ReportedReadings readings;
  RandomStream random(11, "dilution");
  for (int placement = 0; placement < placements; ++placement) {
    for (const auto& [feature, x] : {std::pair{"A", 0.0}, std::pair{"B", 500.0}}) {
      readings.touch_ball({"bar", fmt::format("{}", placement), feature, "", ""}, {x, 300.0, 50.0}, 12.5, directions,
                          noise, random);
    }
  }
  const testing::SessionMaterial material(readings.recording(), {bar_of_two()}, by);
  return verify_iso10360_12(material.session()).value();
}

// Touches within 20 degrees of the direction along the bar: 18.5 times the scatter for each centre.
TEST(PointUncertainty, AgreesWithTheNormalEquations) {
  for (const double polar : {20.0, 45.0, 60.0, 90.0}) {
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.6, 0, 0.8)}) {
      const Directions directions = cross(polar, axis);
      const Verification result = of_bar(directions, 1, 1e-4, by_limit(10.0));
      const double expected = std::sqrt(inverse_normal_matrix(directions)(0, 0));
      EXPECT_NEAR(result.values.at(0).dilution.worst, expected, 2e-3 * expected) << polar;
      EXPECT_NEAR(result.values.at(0).dilution.of_value[0], std::sqrt(2.0) * expected, 3e-3 * expected) << polar;
    }
  }
  EXPECT_NEAR(std::sqrt(inverse_normal_matrix(cross(20.0, Eigen::Vector3d::UnitX()))(0, 0)), 18.54, 0.01);
}

// 2,000 lengths: their spread is known to 1.6 % (k = 1), and that of one touch, by 4,000 degrees of freedom, to 1.1 %.
TEST(PointUncertainty, IsTheSpreadOfTheValues) {
  const Verification result = of_bar(cross(40.0, {0.8, 0.6, 0.0}), 2000, 0.002, by_limit(10.0));
  double squares = 0.0;
  for (const TestValue& value : result.values) {
    squares += value.value * value.value;
  }
  const double spread = std::sqrt(squares / static_cast<double>(result.values.size()));
  EXPECT_NEAR(result.values.front().budget.points, spread, 0.06 * spread);
  EXPECT_GT(spread, 0.006);
}

TEST(PointUncertainty, OfADiameterAgreesWithTheNormalEquations) {
  testing::ReportedReadings readings;
  RandomStream random(12, "diameter");
  const Directions directions = cross(45.0, Eigen::Vector3d::UnitZ());
  readings.touch_ball({"ball", "1", "ball", "", ""}, {500.0, 0.0, 100.0}, 12.5, directions, 1e-4, random);
  Artefact artefact = bar_of_two();
  artefact.name = "ball";
  artefact.features = {testing::ball("ball", 25.0)};
  artefact.distances.clear();
  const testing::SessionMaterial material(readings.recording(), {artefact}, by_limit(1.0));
  const Verification result = verify_iso10360_12(material.session()).value();
  const double of_radius = std::sqrt(inverse_normal_matrix(directions)(3, 3));
  EXPECT_NEAR(worst_of(result, Quantity::SizeError)->dilution.of_value[0], 2.0 * of_radius, 5e-3 * of_radius);
}

TEST(PointUncertainty, ASmallPatchShowsNothingUnderAnyRule) {
  Specification by = by_limit(1.0);
  by.rule = DecisionRule::Simple;
  const Verification patch = of_bar(cross(20.0, Eigen::Vector3d::UnitX()), 3, 1e-4, by);
  EXPECT_EQ(patch.conclusion, Conclusion::ConformityNotShown);
  EXPECT_THAT(patch.missing, ::testing::ElementsAre(::testing::AllOf(HasSubstr("[centre_dilution]"), HasSubstr("18."),
                                                                     HasSubstr("the worst of 3 such values"))));
  by.waived = {Evidence::CentreDilution};
  EXPECT_EQ(of_bar(cross(20.0, Eigen::Vector3d::UnitX()), 3, 1e-4, by).conclusion, Conclusion::ConformityProven);
  by.waived.clear();
  EXPECT_EQ(of_bar(cross(90.0, Eigen::Vector3d::UnitX()), 3, 1e-4, by).conclusion, Conclusion::ConformityProven);
  // A patch on the side is sound for a length along it: that is where it determines the centres.
  EXPECT_EQ(of_bar(cross(40.0, Eigen::Vector3d::UnitZ()), 3, 1e-4, by).conclusion, Conclusion::ConformityProven);
}

// The guard band follows u: what is proven with good touches is not with poor ones of the same scatter.
TEST(PointUncertainty, DecidesWithTheVerdict) {
  const double noise = 0.002;
  const Specification by = by_limit(0.025);
  EXPECT_EQ(of_bar(cross(90.0, Eigen::Vector3d::UnitX()), 20, noise, by).conclusion, Conclusion::ConformityProven);
  const Verification poor = of_bar(cross(40.0, Eigen::Vector3d::UnitX()), 20, noise, by);
  EXPECT_EQ(poor.conclusion, Conclusion::ConformityNotShown);
  EXPECT_THAT(poor.missing, IsEmpty());
  EXPECT_THAT(poor.warnings, Contains(HasSubstr("on so small a part of it")));
}

// Four touches determine a sphere and leave no residual.
TEST(PointUncertainty, WithoutRedundancyItIsSaid) {
  Directions four = cross(90.0, Eigen::Vector3d::UnitX());
  four.pop_back();
  const Verification result = of_bar(four, 3, 1e-4, by_limit(1.0));
  EXPECT_EQ(result.conclusion, Conclusion::ConformityNotShown);
  EXPECT_THAT(result.missing, Contains(HasSubstr("the scatter of the touches is not known")));
}

// Two balls with a degree of freedom each: Student's 2.92 for 95 % one-sided instead of 1.65.
TEST(PointUncertainty, FewDegreesOfFreedomWidenTheGuardBand) {
  const Verification result = of_bar(cross(90.0, Eigen::Vector3d::UnitX()), 1, 0.01, by_limit(1.0));
  const Budget& budget = result.values.at(0).budget;
  EXPECT_NEAR(budget.degrees_of_freedom(), 2.0, 0.05);
  EXPECT_NEAR(guard_band(DecisionRule::Iso14253_2017, 1.0, 2.0), 2.919986, 1e-5);
  EXPECT_NEAR(guard_band(DecisionRule::Iso14253_2013, 1.0, 2.0), 4.5266, 1e-3);
  EXPECT_EQ(guard_band(DecisionRule::Iso14253_2017, 1.0), 1.65);
}

// Two orientations 40 µm apart on patches along that direction: their distance is L_Dia, and both centres hold it.
TEST(PointUncertainty, OfLocationIsThatOfTheCentresThatHoldTheSphere) {
  testing::ReportedReadings readings;
  RandomStream random(13, "location");
  const Directions directions = cross(40.0, Eigen::Vector3d::UnitX());
  for (int i = 0; i < 5; ++i) {
    const double x = i == 0 ? -0.02 : i == 1 ? 0.02 : 0.001 * i;
    readings.touch_ball({"ball", "1", "ball", fmt::format("o{}", i), ""}, {500.0 + x, 0.0, 100.0}, 12.5, directions,
                        1e-6, random);
  }
  Artefact artefact = bar_of_two();
  artefact.name = "ball";
  artefact.features = {testing::ball("ball", 25.0)};
  artefact.distances.clear();
  const testing::SessionMaterial material(readings.recording(), {artefact}, by_limit(1.0));
  const Verification result = verify_iso10360_12(material.session()).value();
  const double along = std::sqrt(inverse_normal_matrix(directions)(0, 0));
  EXPECT_NEAR(worst_of(result, Quantity::LocationDiameter)->dilution.of_value[0], std::sqrt(2.0) * along, 0.02 * along);
}

}  // namespace
}  // namespace artcal
