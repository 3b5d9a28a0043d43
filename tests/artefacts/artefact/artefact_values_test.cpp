// Uncertainties, rules and temperatures of artefact.toml, through the file.
#include "artefacts/artefact/artefact_values.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/artefact/artefact_file.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using testing::replaced;
using ::testing::StartsWith;

constexpr std::string_view plate =
    "schema = \"artcal-artefact/1\"\n"
    "name = \"plate\"\n"
    "units = { length = \"mm\" }\n"
    "expansion_per_K = 10e-6\n"
    "[[feature]]\nname = \"A\"\nkind = \"sphere\"\nat = [0, 0, 0]\ndiameter = 20\nU_at = 0.004\nU_diameter = \"1 "
    "um\"\nk = 2\n"
    "[[feature]]\nname = \"B\"\nkind = \"sphere\"\nat = [300, 400, 0]\ndiameter = 20\n"
    "[[distance]]\nbetween = [\"A\", \"B\"]\nvalue = 500.002\nU = \"2 um\"\nk = 2\n";

class ArtefactValuesTest : public ::testing::Test {
 protected:
  Expected<ArtefactFile> read(const std::string& text) { return read_artefact_file(folder_.write("plate.toml", text)); }
  Artefact accepted(std::string_view from, std::string_view to) {
    const auto file = read(replaced(std::string(plate), from, to));
    EXPECT_TRUE(file) << file.error().text();
    return file ? file->artefact : Artefact{};
  }
  std::string refusal(std::string_view from, std::string_view to) {
    const auto file = read(replaced(std::string(plate), from, to));
    return file ? "accepted" : file.error().text().substr(folder_.path().string().size() + 1);
  }
  testing::TemporaryFolder folder_;
};

TEST_F(ArtefactValuesTest, ReadsUncertaintiesInTheFilesUnitAndInTheirOwn) {
  const Artefact artefact = accepted("name = \"plate\"", "");
  EXPECT_DOUBLE_EQ(artefact.features.at(0).u_at, 0.002);
  EXPECT_DOUBLE_EQ(artefact.features.at(0).u_radius, 0.00025) << "half of U/k of the diameter";
  EXPECT_EQ(artefact.features.at(1).u_at, 0.0) << "not stated";
  EXPECT_DOUBLE_EQ(artefact.distances.at(0).u, 0.001);
}

TEST_F(ArtefactValuesTest, TakesAFactorOfItsOwnBeforeTheCommonOne) {
  const Artefact artefact = accepted("k = 2\n[[feature]]", "k = 2\nk_at = 4\n[[feature]]");
  EXPECT_DOUBLE_EQ(artefact.features.at(0).u_at, 0.001);
  EXPECT_DOUBLE_EQ(artefact.features.at(0).u_radius, 0.00025);
}

TEST_F(ArtefactValuesTest, EvaluatesRulesAtEachLength) {
  for (const auto& [rule, u] :
       {std::pair{"a + b*L", 0.5 * (0.4e-3 + 2e-6 * 500.002)}, std::pair{"a+b·L", 0.5 * (0.4e-3 + 2e-6 * 500.002)},
        std::pair{"sqrt(a^2 + (b*L)^2)", 0.5 * std::hypot(0.4e-3, 2e-6 * 500.002)},
        std::pair{"U = √(a² + (bL)²)", 0.5 * std::hypot(0.4e-3, 2e-6 * 500.002)}}) {
    const Artefact artefact =
        accepted("[[distance]]\nbetween = [\"A\", \"B\"]\nvalue = 500.002\nU = \"2 um\"\nk = 2\n",
                 "[uncertainty]\ndistance = { rule = \"" + std::string(rule) +
                     "\", a = \"0.4 um\", b = \"2 um/m\", k = 2 }\n[[distance]]\nbetween = [\"A\", "
                     "\"B\"]\nvalue = 500.002\n");
    ASSERT_EQ(artefact.distances.size(), 1u) << rule;
    EXPECT_NEAR(artefact.distances.at(0).u, u, 1e-15) << rule;
  }
}

TEST_F(ArtefactValuesTest, RefusesARuleAndAValue) {
  EXPECT_THAT(refusal("expansion_per_K = 10e-6\n", "uncertainty.at = { U = \"2 um\", k = 2 }\n"),
              StartsWith("plate.toml:10:8: `U_at` is stated here, and [uncertainty] has a rule for it"));
}

TEST_F(ArtefactValuesTest, RefusesRulesWithoutUnitsOrSense) {
  const auto with_rule = [&](const std::string& rule) {
    return refusal("expansion_per_K = 10e-6\n", "uncertainty.distance = { " + rule + " }\n");
  };
  EXPECT_THAT(with_rule("rule = \"a + b*L\", a = 0.4, b = \"2 um/m\", k = 2"),
              HasSubstr("`a` in [distance] is a number, expected text in quotes"));
  EXPECT_THAT(with_rule("rule = \"a + b*L\", a = \"0.4\", b = \"2 um/m\", k = 2"),
              HasSubstr("`a` is \"0.4\", expected a number of zero or more with its unit, such as \"0.5 um\""));
  EXPECT_THAT(with_rule("rule = \"a + b*L\", a = \"0.4 um\", b = \"2 um\", k = 2"), HasSubstr("such as \"1.2 um/m\""));
  EXPECT_THAT(with_rule("rule = \"a + b*L\", a = \"0.4 um\", b = \"2 ppm\""), HasSubstr("`k` is missing"));
  EXPECT_THAT(with_rule("rule = \"a * L\", a = \"0.4 um\", b = \"2 ppm\", k = 2"), HasSubstr("the rule is \"a * L\""));
  EXPECT_THAT(with_rule("rule = \"a + b*L\", a = \"0 um\", b = \"2 ppm\", k = 2"),
              HasSubstr("an uncertainty of zero or less is not one"));
  EXPECT_THAT(with_rule("U = \"1 um\", k = -2"), HasSubstr("an uncertainty of zero or less is not one"));
  EXPECT_THAT(with_rule("U = nan, k = 2"), HasSubstr("expected a finite number"));
}

TEST_F(ArtefactValuesTest, RefusesUncertaintiesThatAreNone) {
  EXPECT_THAT(refusal("U_at = 0.004", "U_at = 0"), StartsWith("plate.toml:10:8: an uncertainty of zero or less"));
  EXPECT_THAT(refusal("U_at = 0.004", "U_at = nan"), HasSubstr("expected a finite number"));
  EXPECT_THAT(refusal("U_at = 0.004", "U_at = \"4\""),
              HasSubstr("expected a length with its unit, such as \"0.8 um\""));
  EXPECT_THAT(refusal("k = 2\n[[feature]]", "k = -2\n[[feature]]"), HasSubstr("an uncertainty of zero or less"));
  EXPECT_THAT(refusal("k = 2\n[[feature]]", "k = 95\n[[feature]]"), HasSubstr("is it the probability in percent?"));
  EXPECT_THAT(refusal("k = 2\n[[feature]]", "[[feature]]"), HasSubstr("`k` is missing in [feature]"));
  EXPECT_THAT(refusal("U = \"2 um\"", "U = 60"), HasSubstr("is much for a distance of 500.002 mm; is it in the wrong"));
  EXPECT_THAT(refusal("U_diameter = \"1 um\"", "U_diameter = 3"), HasSubstr("is much for a diameter of 20 mm"));
}

TEST_F(ArtefactValuesTest, ConvertsWhatHoldsAtAnotherTemperature) {
  const Artefact artefact = accepted("value = 500.002", "value = 500.007\ntemperature_C = 21");
  EXPECT_NEAR(artefact.distances.at(0).value, 500.007 / (1.0 + 10e-6), 1e-12);
  const StatedValue stated = artefact.stated(artefact.distances.at(0));
  EXPECT_EQ(stated.value, 500.007);
  EXPECT_EQ(stated.temperature, 21.0);
  const Artefact at_reference = accepted("value = 500.002", "value = 500.003");
  EXPECT_EQ(at_reference.stated(at_reference.distances.at(0)).value, 500.003);
  EXPECT_EQ(at_reference.stated(at_reference.distances.at(0)).temperature, at_reference.reference_temperature);
  EXPECT_THAT(refusal("value = 500.002", "value = 500.002\ntemperature_C = 220"),
              HasSubstr("220 degC is no temperature"));
  const std::string without = replaced(std::string(plate), "expansion_per_K = 10e-6\n", "");
  const auto file = read(replaced(without, "value = 500.002", "value = 500.002\ntemperature_C = 21"));
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().text(), HasSubstr("without expansion_per_K it cannot be converted"));
}

TEST_F(ArtefactValuesTest, AddsTheDoubtOfTheExpansionToConvertedValues) {
  const std::string known = replaced(std::string(plate), "expansion_per_K = 10e-6\n",
                                     "expansion_per_K = 10e-6\nU_expansion_per_K = 4e-6\nk_expansion = 2\n");
  const auto file = read(replaced(known, "value = 500.002", "value = 500.007\ntemperature_C = 21"));
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_DOUBLE_EQ(file->artefact.u_expansion, 2e-6);
  EXPECT_NEAR(file->artefact.distances.at(0).u, std::hypot(0.001, 500.002 * 2e-6), 1e-8);
}

TEST_F(ArtefactValuesTest, RefusesExpansionUncertaintiesThatAreNone) {
  const auto with = [&](const std::string& text) { return refusal("expansion_per_K = 10e-6\n", text); };
  const std::string alpha = "expansion_per_K = 10e-6\n";
  EXPECT_THAT(with(alpha + "U_expansion_per_K = 1e-6\n"), HasSubstr("`k_expansion` is missing"));
  EXPECT_THAT(with(alpha + "U_expansion_per_K = 0\nk_expansion = 2\n"),
              HasSubstr("a standard uncertainty of 0 per kelvin"));
  EXPECT_THAT(with(alpha + "u_expansion_per_K = 1\n"), HasSubstr("a standard uncertainty of 1 per kelvin is none"));
  EXPECT_THAT(with("u_expansion_per_K = 1e-6\n"), HasSubstr("but not the expansion itself"));
  EXPECT_THAT(with(alpha + "u_expansion_per_K = 1e-6\nU_expansion_per_K = 1e-6\nk_expansion = 2\n"),
              HasSubstr("not both"));
}

TEST_F(ArtefactValuesTest, ReadsRowsOfDistances) {
  const auto row = [](const std::string& values) {
    return "schema = \"artcal-artefact/1\"\nunits = { length = \"mm\" }\nexpansion_per_K = 10e-6\n"
           "feature = [{ name = \"1\", kind = \"point\" }, { name = \"2\", kind = \"point\" }, { name = \"3\", kind = "
           "\"point\" }]\n[[distance]]\nalong = [\"1\", \"2\", \"3\"]\nU = 0.002\nk = 2\n" +
           values;
  };
  const auto steps = read(row("steps = [100, 200]\ntemperatures_C = [20, 21]\n"));
  ASSERT_TRUE(steps) << steps.error().text();
  ASSERT_EQ(steps->artefact.distances.size(), 2u);
  EXPECT_EQ(steps->artefact.distances.at(0).value, 100.0);
  EXPECT_EQ(steps->artefact.distances.at(1).first, 1);
  EXPECT_NEAR(steps->artefact.distances.at(1).value, 200.0 / 1.00001, 1e-12);
  const auto positions = read(row("positions = [100, 300]\n"));
  ASSERT_TRUE(positions) << positions.error().text();
  EXPECT_EQ(positions->artefact.distances.at(1).first, 0);
  EXPECT_EQ(positions->artefact.distances.at(1).second, 2);
  EXPECT_EQ(positions->artefact.distances.at(1).value, 300.0);
  EXPECT_THAT(read(row("steps = [100]\n")).error().text(), HasSubstr("there are 1 values along 3 features"));
  EXPECT_THAT(read(row("steps = [100, 200]\npositions = [100, 300]\n")).error().text(), HasSubstr("not both"));
  EXPECT_THAT(read(row("steps = [100, 200]\ntemperatures_C = [20]\n")).error().text(),
              HasSubstr("there are 1 temperatures for 2 values"));
}

}  // namespace
}  // namespace artcal
