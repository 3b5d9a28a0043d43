#include "artefacts/verification/decision/plausibility_of_test.h"

#include <functional>

#include <gmock/gmock.h>

#include "artefacts/verification/iso10360_12/iso10360_12.h"
#include "tests/support/reported_readings.h"

namespace artcal {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::SessionMaterial;

Verification verified(const std::function<void(SessionMaterial&)>& change, double temperature = 20.0) {
  testing::ReportedReadings readings;
  RandomStream random(1, "plausibility");
  readings.touch_ball({"ball", "1", "ball", "", ""}, {500.0, 0.0, 100.0}, 12.5, testing::pattern_25(), 1e-5, random,
                      temperature);
  Artefact artefact;
  artefact.name = "ball";
  artefact.features = {testing::ball("ball", 25.0)};
  Specification by;
  by.limits = {{Quantity::SizeError, {0.074, 0.0, {}}}, {Quantity::FormError, {0.074, 0.0, {}}}};
  by.rule = DecisionRule::Simple;
  by.plan = TestPlan{};
  by.measuring_range = 1800.0;
  SessionMaterial material(readings.recording(), {artefact}, by);
  change(material);
  return verify_iso10360_12(material.session()).value();
}

TEST(PlausibilityOfTest, NumbersOfOtherUnitsAreNamedAndShowNothing) {
  EXPECT_EQ(verified([](SessionMaterial&) {}).conclusion, Conclusion::ConformityProven);
  const std::vector<std::pair<std::function<void(SessionMaterial&)>, std::string>> cases{
      {[](SessionMaterial& m) {
         m.specification.limits[Quantity::SizeError] = {7.4, 0.0, {}};
       },
       "the limit of P_Size is 7.4 mm"},
      {[](SessionMaterial& m) {
         m.specification.limits[Quantity::FormError] = {74.0, 0.0, {}};
       },
       "the limit of P_Form is 74 mm"},
      {[](SessionMaterial& m) { m.specification.measuring_range = 1.8; }, "measuring_range is 1.8 mm"},
      {[](SessionMaterial& m) { m.specification.highest_temperature = 72.0; },
       "highest_C is 72.0 degC (degrees Fahrenheit? 22.2 degC)"},
      {[](SessionMaterial& m) { m.specification.u_fixture = 1.0; }, "`fixture` is 1 mm"},
      {[](SessionMaterial& m) { m.specification.u_temperature = 100.0; }, "uncertainty of the temperature is 100 K"},
      {[](SessionMaterial& m) { m.constraints.artefacts[0].features[0].u_radius = 0.3; }, "the diameter of \"ball\""}};
  for (const auto& [change, words] : cases) {
    const Verification result = verified(change);
    EXPECT_EQ(result.conclusion, Conclusion::ConformityNotShown) << words;
    EXPECT_THAT(result.missing, ElementsAre(::testing::AllOf(HasSubstr(words), HasSubstr("[plausible_values]"))));
    const Verification waived = verified([&, &change = change](SessionMaterial& material) {
      change(material);
      material.specification.waived = {Evidence::PlausibleValues};
    });
    EXPECT_EQ(waived.conclusion, Conclusion::ConformityProven) << words;
  }
}

TEST(PlausibilityOfTest, ALimitOfNanometresIsNamed) {
  const Verification result = verified([](SessionMaterial& m) {
    m.specification.limits[Quantity::SizeError] = {7.4e-5, 0.0, {}};
  });
  EXPECT_THAT(result.missing, Contains(HasSubstr("the limit of P_Size is 74 nm")));
}

TEST(PlausibilityOfTest, ReadingsInFahrenheitAreNamed) {
  const Verification result = verified([](SessionMaterial&) {}, 68.7);
  EXPECT_EQ(result.conclusion, Conclusion::ConformityNotShown);
  EXPECT_THAT(result.missing, Contains(HasSubstr("68.70 degC (degrees Fahrenheit? 20.4 degC)")));
}

}  // namespace
}  // namespace artcal
