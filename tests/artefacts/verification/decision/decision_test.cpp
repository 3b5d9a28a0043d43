#include "artefacts/verification/decision/decision.h"

#include <cmath>

#include <gtest/gtest.h>

#include "artefacts/verification/decision/budget.h"
#include "artefacts/verification/decision/limit.h"
#include "artefacts/verification/decision/specification.h"
#include "core/random.h"

namespace artcal {
namespace {

TEST(Limit, HasThreeForms) {
  EXPECT_EQ(Limit({0.025, 0.0, {}}).at(1000.0), 0.025);
  const Limit growing{0.020, 0.001 / 50.0, {}};  // 20 um + L/50, L in mm
  EXPECT_DOUBLE_EQ(growing.at(0.0), 0.020);
  EXPECT_DOUBLE_EQ(growing.at(1000.0), 0.040);
  const Limit capped{0.020, 0.001 / 50.0, 0.035};
  EXPECT_DOUBLE_EQ(capped.at(500.0), 0.030);
  EXPECT_DOUBLE_EQ(capped.at(1000.0), 0.035);
}

// L = 1 m, U = 0.7 um (k = 2), 11.5 ± 0.5 ppm/K, 23 °C, u(T) = 0.1 K: worked out by hand.
TEST(Budget, OfOneMetreOfSteel) {
  const Budget budget = with_thermal({0.35e-3}, 1000.0, {11.5e-6, 0.5e-6, 3.0, 0.1});
  EXPECT_NEAR(budget.calibration, 0.35e-3, 1e-12);
  EXPECT_NEAR(budget.expansion, 1.50e-3, 1e-12);
  EXPECT_NEAR(budget.temperature, 1.15e-3, 1e-12);
  EXPECT_NEAR(budget.total(), 1.92e-3, 0.005e-3);
}

TEST(Budget, AddsEveryPart) {
  EXPECT_DOUBLE_EQ(Budget({1.0, 2.0, 2.0, 4.0, 5.0, 6.0}).total(), std::sqrt(86.0));
  EXPECT_DOUBLE_EQ(form_uncertainty(0.6, 0.4), 0.5);
  // It does not matter on which side of the reference the temperature is.
  EXPECT_GT(with_thermal({}, 1000.0, {11.5e-6, 0.5e-6, -3.0, 0.1}).expansion, 0.0);
}

// Ranges, the diameter of a smallest sphere and 2·s are sizes; what is measured less what is certified is an error.
TEST(Quantity, HasASignWhereItIsAnError) {
  for (const char* name : {"P_Form", "P_Form.Sph.D95%", "L_Dia", "SPAT", "SPAT_2s"}) {
    EXPECT_FALSE(is_signed(quantity_named(name).value())) << name;
  }
  for (const char* name : {"P_Size", "P_Size.Sph.All", "E_Uni", "E_Bi", "effective_diameter", "volumetric"}) {
    EXPECT_TRUE(is_signed(quantity_named(name).value())) << name;
  }
}

TEST(Decision, HasThreeZones) {
  constexpr auto rule = DecisionRule::Iso14253_2017;
  constexpr double limit = 0.020, u = 0.002;  // guard band 0.0033
  EXPECT_EQ(decide(0.0166, limit, u, rule), Verdict::ConformityProven);
  EXPECT_EQ(decide(-0.0166, limit, u, rule), Verdict::ConformityProven);
  EXPECT_EQ(decide(0.0168, limit, u, rule), Verdict::NeitherProven);
  EXPECT_EQ(decide(-0.0232, limit, u, rule), Verdict::NeitherProven);
  EXPECT_EQ(decide(0.0234, limit, u, rule), Verdict::NonConformityProven);
  EXPECT_EQ(decide(0.0165, limit, u, DecisionRule::Iso14253_2013), Verdict::NeitherProven);
  EXPECT_EQ(decide(0.0159, limit, u, DecisionRule::Iso14253_2013), Verdict::ConformityProven);
  EXPECT_EQ(decide(0.0200, limit, u, DecisionRule::Simple), Verdict::ConformityProven);
  EXPECT_EQ(decide(0.0201, limit, u, DecisionRule::Simple), Verdict::NonConformityProven);
}

TEST(Decision, NothingConformsInsideTooWideAGuardBand) {
  EXPECT_EQ(decide(0.0, 0.001, 0.001, DecisionRule::Iso14253_2017), Verdict::NeitherProven);
  EXPECT_EQ(decide(0.0, 0.0, 0.0, DecisionRule::Iso14253_2017), Verdict::ConformityProven);
}

/// How often a machine with this true error gets each verdict when the test value scatters by u.
struct Rates {
  double conforms = 0.0, fails = 0.0;
};
Rates rates_at(double true_error, double limit, double u, DecisionRule rule) {
  constexpr int count = 200000;
  RandomStream random(1, "verdicts near the limit");
  Rates rates;
  for (int i = 0; i < count; ++i) {
    const Verdict verdict = decide(true_error + u * random.normal(), limit, u, rule);
    rates.conforms += verdict == Verdict::ConformityProven ? 1.0 / count : 0.0;
    rates.fails += verdict == Verdict::NonConformityProven ? 1.0 / count : 0.0;
  }
  return rates;
}

// At the limit, where wrong verdicts are most frequent: Φ(-1.65) = 4.95 %, Φ(-2) = 2.28 %, Φ(0) = 50 %.
TEST(Decision, IsWrongAsOftenAsTheRuleSays) {
  constexpr double limit = 0.020, u = 0.002;
  for (const auto& [rule, promised] :
       {std::pair{DecisionRule::Iso14253_2017, 0.0495}, std::pair{DecisionRule::Iso14253_2013, 0.0228},
        std::pair{DecisionRule::Simple, 0.5}}) {
    const double scatter = 4.0 * std::sqrt(promised * (1.0 - promised) / 200000);
    for (const double side : {-1.0, 1.0}) {
      const Rates rates = rates_at(side * limit, limit, u, rule);
      EXPECT_NEAR(rates.conforms, promised, scatter) << text_of(rule);
      EXPECT_NEAR(rates.fails, promised, scatter) << text_of(rule);
    }
    // Farther off, wrong verdicts are rarer still.
    EXPECT_LT(rates_at(1.05 * limit, limit, u, rule).conforms, promised);
    EXPECT_LT(rates_at(0.95 * limit, limit, u, rule).fails, promised);
  }
}

}  // namespace
}  // namespace artcal
