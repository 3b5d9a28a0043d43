#include "artefacts/verification/iso10360_12/iso10360_12.h"

#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/support/reported_readings.h"

namespace artcal {
namespace {

using testing::ball;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Label;
using ::testing::Not;

Artefact single_ball() {
  Artefact artefact;
  artefact.name = "ball";
  artefact.features = {ball("ball", 25.0)};
  artefact.expansion = 5.5e-6;
  artefact.u_expansion = 0.5e-6;
  artefact.expansion_is_known = true;
  return artefact;
}

// Balls 0 … 5 on a line; certified from ball 0.
Artefact bar_of_six() {
  Artefact bar = single_ball();
  bar.name = "bar";
  bar.features.clear();
  for (int i = 0; i < 6; ++i) {
    bar.features.push_back(ball(fmt::format("{}", i), 25.0));
  }
  for (int i = 1; i < 6; ++i) {
    bar.distances.push_back({0, i, 200.0 * i, 0.4e-3});
  }
  return bar;
}

Specification specification() {
  Specification by;
  by.name = "made up";
  by.limits = {{Quantity::SizeError, {0.020, 0.0, {}}},
               {Quantity::FormError, {0.040, 0.0, {}}},
               {Quantity::LocationDiameter, {0.050, 0.0, {}}},
               {Quantity::LengthUni, {0.020, 0.001 / 100.0, {}}}};
  by.measuring_range = 1500.0;
  by.lowest_temperature = 18.0;
  by.highest_temperature = 22.0;
  by.u_temperature = 0.1;
  TestPlan plan;
  plan.sphere_positions = 2;
  plan.points = 25;
  plan.orientations = 5;
  plan.points_per_orientation = 5;
  plan.lengths = 5;
  plan.positions = 7;
  plan.repeats = 3;
  plan.longest_share = 0.66;
  by.plan = plan;
  return by;
}

/// The full test, with what a case wants otherwise.
struct Case {
  double noise = 0.001;
  double scale = 1.0;  ///< of everything the arm reports
  double temperature = 20.0;
  std::function<bool(const Label&)> leaves_out = [](const Label&) { return false; };
  std::function<Eigen::Vector3d(const Label&)> error = [](const Label&) { return Eigen::Vector3d::Zero(); };

  [[nodiscard]] Recording recording() const {
    testing::ReportedReadings readings;
    RandomStream random(7, "full test");
    const auto touch = [&](const Label& label, const Eigen::Vector3d& centre, const auto& directions) {
      if (!leaves_out(label)) {
        readings.touch_ball(label, scale * centre + error(label), 12.5, directions, noise, random, temperature);
      }
    };
    for (int position = 1; position <= 2; ++position) {
      const Eigen::Vector3d centre{500.0 * position, -300.0, 200.0};
      touch({"ball", fmt::format("b{}", position), "ball", "", ""}, centre, testing::pattern_25());
      for (int orientation = 1; orientation <= 5; ++orientation) {
        touch({"ball", fmt::format("b{}", position), "ball", fmt::format("o{}", orientation), ""}, centre,
              testing::pattern_5());
      }
    }
    for (int position = 1; position <= 7; ++position) {
      const Rigid base_from_bar{random.rotation(), 300.0 * random.direction()};
      const double expansion_factor = std::isfinite(temperature) ? 1.0 + 5.5e-6 * (temperature - 20.0) : 1.0;
      for (int repeat = 1; repeat <= 3; ++repeat) {
        for (int i = 0; i < 6; ++i) {
          touch({"bar", fmt::format("{}", position), fmt::format("{}", i), "", fmt::format("{}", repeat)},
                base_from_bar * Eigen::Vector3d(expansion_factor * 200.0 * i, 0.0, 0.0), testing::pattern_25());
        }
      }
    }
    return readings.recording();
  }
};

Verification verified(const Case& planted, const Specification& by = specification()) {
  const testing::SessionMaterial material(planted.recording(), {single_ball(), bar_of_six()}, by);
  return verify_iso10360_12(material.session()).value();
}

TEST(Iso10360_12, AGoodArmConforms) {
  const Verification result = verified({});
  EXPECT_EQ(result.conclusion, Conclusion::ConformityProven);
  EXPECT_THAT(result.missing, IsEmpty());
  EXPECT_EQ(result.values.size(), 2u + 2u + 2u + 105u);
  for (const TestValue& value : result.values) {
    EXPECT_EQ(value.verdict, Verdict::ConformityProven) << label_of(value);
    EXPECT_LT(std::abs(value.value), 0.010) << label_of(value);
  }
}

TEST(Iso10360_12, PlantedErrorsComeOut) {
  Case planted;
  planted.noise = 0.0;
  // Centres of three orientations at the corners of an equilateral triangle of side 30 µm; the others within.
  planted.error = [](const Label& label) -> Eigen::Vector3d {
    if (label.artefact != "ball" || label.placement != "b2") return Eigen::Vector3d::Zero();
    if (label.orientation == "o1") return {0.030, 0.0, 0.0};
    if (label.orientation == "o2") return {0.015, 0.030 * std::sqrt(0.75), 0.0};
    if (label.orientation == "o3") return {0.0, 0.0, 0.0};
    return {0.015, 0.010, 0.0};
  };
  const Verification result = verified(planted);
  EXPECT_NEAR(worst_of(result, Quantity::LocationDiameter)->value, 0.034641, 5e-7);
  EXPECT_EQ(worst_of(result, Quantity::LocationDiameter)->placement, "b2");
  EXPECT_NEAR(worst_of(result, Quantity::SizeError)->value, 0.0, 1e-9);
  EXPECT_NEAR(worst_of(result, Quantity::LengthUni)->value, 0.0, 1e-9);
}

// A regular tetrahedron of edge 30: the sphere around it, not its edge.
TEST(Iso10360_12, LocationDiameterOfATetrahedron) {
  Case planted;
  planted.noise = 0.0;
  planted.error = [](const Label& label) -> Eigen::Vector3d {
    const double half = 0.5 * 0.030 / std::sqrt(2.0);
    if (label.placement != "b1") return Eigen::Vector3d::Zero();
    if (label.orientation == "o1") return half * Eigen::Vector3d(1.0, 1.0, 1.0);
    if (label.orientation == "o2") return half * Eigen::Vector3d(1.0, -1.0, -1.0);
    if (label.orientation == "o3") return half * Eigen::Vector3d(-1.0, 1.0, -1.0);
    if (label.orientation == "o4") return half * Eigen::Vector3d(-1.0, -1.0, 1.0);
    return Eigen::Vector3d::Zero();
  };
  EXPECT_NEAR(worst_of(verified(planted), Quantity::LocationDiameter)->value, 0.036742, 5e-7);
}

TEST(Iso10360_12, AScaleErrorFails) {
  Case planted;
  planted.noise = 0.0;
  planted.scale = 1.0 + 60e-6;  // 60 um on a metre, where 30 um are allowed
  const Verification result = verified(planted);
  EXPECT_EQ(result.conclusion, Conclusion::NonConformityProven);
  const TestValue* worst = worst_of(result, Quantity::LengthUni);
  EXPECT_NEAR(worst->value, 0.060, 1e-9);
  EXPECT_DOUBLE_EQ(*worst->limit, 0.030);
  EXPECT_EQ(worst->second, "5");
}

TEST(Iso10360_12, LengthsAreComparedAtTwentyDegrees) {
  Case planted;
  planted.noise = 0.0;
  planted.temperature = 22.0;
  Specification warm = specification();
  const Verification result = verified(planted, warm);
  EXPECT_NEAR(worst_of(result, Quantity::LengthUni)->value, 0.0, 1e-8);
  // u: 0.4 µm; 1 m · 2 K · 0.5 ppm/K = 1 µm; 1 m · 5.5 ppm/K · 0.1 K = 0.55 µm.
  EXPECT_NEAR(worst_of(result, Quantity::LengthUni)->budget.calibration, 0.4e-3, 1e-12);
  for (const TestValue& value : result.values) {
    if (value.quantity == Quantity::LengthUni && value.second == "5") {
      EXPECT_NEAR(value.budget.expansion, 1.0e-3, 1e-9);
      EXPECT_NEAR(value.budget.temperature, 0.55e-3, 1e-9);
    }
  }
  warm.highest_temperature = 21.0;
  const Verification outside = verified(planted, warm);
  EXPECT_EQ(outside.conclusion, Conclusion::ConformityNotShown);
  EXPECT_THAT(outside.missing, Contains(HasSubstr("22.0 degC is outside the rated conditions")));
}

TEST(Iso10360_12, AnAbsentTemperatureIsSaid) {
  Case planted;
  planted.temperature = std::nan("");
  const Verification result = verified(planted);
  EXPECT_EQ(result.conclusion, Conclusion::ConformityNotShown);
  EXPECT_THAT(result.missing, Contains(HasSubstr("temperature was not read")));
}

TEST(Iso10360_12, WhatIsMissingIsSaidAndConformityNotShown) {
  const auto missing_without = [](const std::function<bool(const Label&)>& leaves_out) {
    Case planted;
    planted.leaves_out = leaves_out;
    const Verification result = verified(planted);
    EXPECT_EQ(result.conclusion, Conclusion::ConformityNotShown);
    return result.missing;
  };
  EXPECT_THAT(missing_without([](const Label& l) { return l.placement == "7"; }),
              Contains(HasSubstr("6 positions of 7 complete")));
  EXPECT_THAT(missing_without([](const Label& l) { return l.placement == "4" && l.repeat == "3" && l.feature == "2"; }),
              Contains(HasSubstr("placement \"4\", 0 - 2: 2 of 3 repeats")));
  EXPECT_THAT(missing_without([](const Label& l) { return l.artefact == "bar" && l.feature == "5"; }),
              Contains(HasSubstr("800.0 mm, 53 % of the measuring range")));
  EXPECT_THAT(missing_without([](const Label& l) { return l.artefact == "ball" && l.placement == "b2"; }),
              Contains(HasSubstr("P_Size and P_Form: 1 position of 2")));
  EXPECT_THAT(missing_without([](const Label& l) { return l.orientation == "o3"; }),
              Contains(HasSubstr("4 orientations of 5 of the wrist")));
  EXPECT_THAT(missing_without([](const Label& l) { return !l.orientation.empty(); }),
              Contains(HasSubstr("L_Dia: a limit is stated, but nothing was measured")));
}

TEST(Iso10360_12, PlannedPositionsAreAskedForByName) {
  Specification by = specification();
  by.plan->named = {{"8", {}}, {"1", {{"0", "5"}, {"5", "0"}, {"1", "2"}}}};
  const Verification result = verified({}, by);
  EXPECT_EQ(result.conclusion, Conclusion::ConformityNotShown);
  EXPECT_THAT(result.missing, ::testing::ElementsAre(HasSubstr("placement \"8\": no length was measured there"),
                                                     HasSubstr("placement \"1\", 1 - 2: 0 of 3 repeats")));
}

TEST(Iso10360_12, WithoutLimitsOrPlanNothingIsShown) {
  Specification empty;
  const Verification result = verified({}, empty);
  EXPECT_EQ(result.conclusion, Conclusion::ConformityNotShown);
  EXPECT_THAT(result.missing, Contains(HasSubstr("has no [plan]")));
  EXPECT_THAT(result.missing, Contains(HasSubstr("E_Uni: no limit is stated")));
  EXPECT_EQ(result.values.front().verdict, Verdict::NotJudged);
}

TEST(Iso10360_12, ACertificateWithoutUIsSaid) {
  Case planted;
  Artefact bar = bar_of_six();
  for (auto& distance : bar.distances) distance.u = 0.0;
  bar.u_expansion = 0.0;
  const testing::SessionMaterial material(planted.recording(), {single_ball(), bar}, specification());
  const Verification result = verify_iso10360_12(material.session()).value();
  EXPECT_EQ(result.conclusion, Conclusion::ConformityNotShown);
  EXPECT_THAT(result.missing, Contains(HasSubstr("states no U of a length")));
  EXPECT_THAT(result.missing, Contains(HasSubstr("no uncertainty of the thermal expansion")));
  // Simple acceptance does not need u.
  Specification simple = specification();
  simple.rule = DecisionRule::Simple;
  const testing::SessionMaterial again(planted.recording(), {single_ball(), bar}, simple);
  EXPECT_EQ(verify_iso10360_12(again.session()).value().conclusion, Conclusion::ConformityProven);
}

// The bar is moved half-way through a placement, and nobody changes the label.
TEST(Iso10360_12, AMovedBarUnderOneLabelIsFound) {
  testing::ReportedReadings readings;
  RandomStream random(3, "moved");
  for (const double shift : {0.0, 40.0}) {
    for (int i = 0; i < 6; ++i) {
      readings.touch_ball({"bar", "1", fmt::format("{}", i), "", "1"}, {200.0 * i + shift, 0.0, 0.0}, 12.5,
                          testing::pattern_5(), 0.001, random);
    }
  }
  const testing::SessionMaterial material(readings.recording(), {bar_of_six()}, specification());
  const auto result = verify_iso10360_12(material.session());
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("do not lie on one ball"));
  EXPECT_THAT(result.error().message, HasSubstr("moved under one placement label"));
}

/// Three repeats and `again` more of one length, of which some are bad.
TEST(Iso10360_12, TheOutlierRuleAsksForTheRepetition) {
  const auto with_repeats = [](int count, const std::vector<int>& bad, const OutlierRule& rule) {
    testing::ReportedReadings readings;
    RandomStream random(5, "outliers");
    for (int repeat = 0; repeat < count; ++repeat) {
      const bool is_bad = std::find(bad.begin(), bad.end(), repeat) != bad.end();
      const Label label{"bar", "1", "", "", fmt::format("r{}", repeat)};
      for (const auto& [feature, x] : {std::pair{"0", 0.0}, std::pair{"5", is_bad ? 1000.1 : 1000.0}}) {
        readings.touch_ball({"bar", "1", feature, "", label.repeat}, {x, 0.0, 0.0}, 12.5, testing::pattern_5(), 0.0,
                            random);
      }
    }
    Specification by = specification();
    by.outliers = rule;
    const testing::SessionMaterial material(readings.recording(), {bar_of_six()}, by);
    return verify_iso10360_12(material.session()).value();
  };
  const OutlierRule rule{5, 1, 10};
  EXPECT_EQ(with_repeats(13, {1}, {}).conclusion, Conclusion::NonConformityProven);
  EXPECT_EQ(with_repeats(13, {1}, rule).conclusion, Conclusion::ConformityNotShown);  // set aside; the rest is missing
  EXPECT_EQ(with_repeats(12, {1}, rule).conclusion, Conclusion::NonConformityProven);
  EXPECT_EQ(with_repeats(13, {1, 2}, rule).conclusion, Conclusion::NonConformityProven);
  EXPECT_EQ(with_repeats(13, {1, 7}, rule).conclusion, Conclusion::NonConformityProven);
  EXPECT_THAT(with_repeats(13, {1}, rule).warnings, Contains(HasSubstr("set aside by the outlier rule")));
}

}  // namespace
}  // namespace artcal
