#include "artefacts/artefact/plausibility.h"

#include <functional>

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Artefact bar() {
  Artefact artefact;
  artefact.name = "bar";
  CertifiedFeature ball;
  ball.name = "A";
  ball.kind = FeatureKind::Sphere;
  ball.radius = 12.7;
  ball.u_radius = 0.1e-3;
  ball.form = 0.2e-3;
  ball.u_form = 0.1e-3;
  CertifiedFeature other = ball;
  other.name = "B";
  artefact.features = {ball, other};
  artefact.distances = {{0, 1, 1000.0, 0.45e-3}};
  artefact.expansion = 11.5e-6;
  artefact.u_expansion = 0.5e-6;
  return artefact;
}

std::vector<std::string> found(const std::function<void(Artefact&)>& change) {
  Artefact artefact = bar();
  change(artefact);
  return implausible_values(artefact);
}

TEST(Plausibility, SoundCertificatesPass) {
  EXPECT_THAT(found([](Artefact&) {}), IsEmpty());
  // As coarse and as fine as artefacts are: 40 um on a long bar, 30 nm on a ball; nothing stated.
  EXPECT_THAT(found([](Artefact& a) { a.distances[0].u = 0.020; }), IsEmpty());
  EXPECT_THAT(found([](Artefact& a) { a.features[0].u_radius = 7.5e-6; }), IsEmpty());
  EXPECT_THAT(found([](Artefact& a) { a.distances[0].u = a.features[0].u_radius = 0.0; }), IsEmpty());
}

// A thousand times too large or too small: mm for um, and um for nm.
TEST(Plausibility, ValuesInAnotherUnitAreNamed) {
  EXPECT_THAT(
      found([](Artefact& a) { a.distances[0].u = 0.45; }),
      ElementsAre(AllOf(HasSubstr("artefact \"bar\": the expanded uncertainty (k = 2) of the length A - B is 0.9 mm"),
                        HasSubstr("is its unit right?"))));
  EXPECT_THAT(found([](Artefact& a) { a.distances[0].u = 0.45e-6; }), ElementsAre(HasSubstr("is 0.9 nm")));
  EXPECT_THAT(found([](Artefact& a) { a.features[1].u_radius = 0.1; }),
              ElementsAre(HasSubstr("the diameter of \"B\"")));
  EXPECT_THAT(found([](Artefact& a) { a.features[0].form = 0.2; }), ElementsAre(HasSubstr("form deviation of \"A\"")));
  EXPECT_THAT(found([](Artefact& a) { a.features[0].radius = 0.0127; }),
              ElementsAre(HasSubstr("diameter of \"A\" is 25.4 um")));
  EXPECT_THAT(found([](Artefact& a) { a.reference_temperature = 68.0; }),
              ElementsAre(HasSubstr("68.00 degC (degrees Fahrenheit? 20.0 degC)")));
  EXPECT_THAT(found([](Artefact& a) { a.expansion = 115e-6; }), ElementsAre(HasSubstr("it expands by")));
}

TEST(Plausibility, TemperaturesInAnotherUnitAreNamed) {
  EXPECT_EQ(unit_of_temperature(68.7), " (degrees Fahrenheit? 20.4 degC)");
  EXPECT_EQ(unit_of_temperature(293.65), " (kelvin? 20.5 degC)");
  EXPECT_EQ(unit_of_temperature(-40.0), "");
  EXPECT_TRUE(is_room_temperature(20.0));
  EXPECT_FALSE(is_room_temperature(68.7));
  Recording recording;
  recording.files = {"r.csv"};
  recording.arm.probes.resize(1);
  recording.readings.resize(3);
  recording.readings[0].line = 2;
  recording.readings[0].temperature = 20.5;
  recording.readings[1].line = 3;
  recording.readings[1].temperature = 68.7;
  recording.readings[2].arm_temperature = 294.0;
  EXPECT_THAT(implausible_values(recording),
              ElementsAre(AllOf(HasSubstr("r.csv:3"), HasSubstr("of the artefact is 68.70 degC"), HasSubstr("1 of 3")),
                          HasSubstr("of the arm is 294.00 degC (kelvin? 20.9 degC)")));
}

TEST(Plausibility, ATipInMetresIsNamed) {
  Recording recording;
  recording.arm.probes.resize(1);
  recording.arm.probes[0].radius = 0.003;
  EXPECT_THAT(implausible_values(recording), ElementsAre(HasSubstr("the radius of the probe \"probe\" is 3 um")));
  recording.arm.probes[0].radius = 0.0;
  EXPECT_THAT(implausible_values(recording), IsEmpty());
}

}  // namespace
}  // namespace artcal
