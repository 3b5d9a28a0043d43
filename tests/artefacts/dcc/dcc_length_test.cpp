// From what a certificate says of a length to what an artefact is given, by certificates of our own.
#include "artefacts/dcc/dcc_length.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/artefact/artefact_file.h"
#include "artefacts/dcc/dcc_relative.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::DoubleNear;
using ::testing::HasSubstr;

constexpr const char* head =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<d:digitalCalibrationCertificate xmlns:d=\"https://ptb.de/dcc\" xmlns:s=\"https://ptb.de/si\" "
    "schemaVersion=\"3.3.0\"><d:administrativeData><d:coreData><d:uniqueIdentifier>N1</d:uniqueIdentifier>"
    "<d:endPerformanceDate>2026-03-02</d:endPerformanceDate></d:coreData></d:administrativeData>"
    "<d:measurementResults><d:measurementResult><d:results><d:result><d:data>\n<d:quantity id=\"q\">";
constexpr const char* tail =
    "</d:quantity></d:data></d:result></d:results></d:measurementResult></d:measurementResults>"
    "</d:digitalCalibrationCertificate>";

std::string real(const std::string& value, const std::string& unit, const std::string& rest = "") {
  return "<s:real><s:value>" + value + "</s:value><s:unit>" + unit + "</s:unit>" + rest + "</s:real>";
}
std::string expanded(const std::string& U, const std::string& k = "2") {
  return "<s:expandedUnc><s:uncertainty>" + U + "</s:uncertainty><s:coverageFactor>" + k +
         "</s:coverageFactor><s:coverageProbability>0.95</s:coverageProbability></s:expandedUnc>";
}
std::string relative(const std::string& value, const std::string& unit, const std::string& rest = "") {
  return "<d:relativeUncertainty><d:relativeUncertaintySingle><s:value>" + value + "</s:value><s:unit>" + unit +
         "</s:unit>" + rest + "</d:relativeUncertaintySingle></d:relativeUncertainty>";
}
std::string hybrid(const std::string& content) { return "<s:hybrid>" + content + "</s:hybrid>"; }

class DccLength : public ::testing::Test {
 protected:
  // A ball whose diameter is the quantity, with more lines in the artefact file.
  Expected<ArtefactFile> ball(const std::string& quantity, const std::string& more = "") {
    (void)folder_.write("c.xml", head + quantity + tail);
    return read_artefact_file(
        folder_.write("ball.toml",
                      "schema = \"artcal-artefact/1\"\ndcc = \"c.xml\"\n"
                      "units = { length = \"mm\" }\n[[feature]]\nname = \"A\"\nkind = \"sphere\"\n"
                      "diameter = { dcc = \"q\" }\n" +
                          more));
  }
  double diameter(const std::string& quantity, const std::string& more = "") {
    const auto file = ball(quantity, more);
    EXPECT_TRUE(file) << file.error().text();
    return file ? 2.0 * *file->artefact.features[0].radius : 0.0;
  }
  double u_diameter(const std::string& quantity, const std::string& more = "") {
    const auto file = ball(quantity, more);
    EXPECT_TRUE(file) << file.error().text();
    return file ? 2.0 * file->artefact.features[0].u_radius : -1.0;
  }
  std::string refusal(const std::string& quantity, const std::string& more = "") {
    const auto file = ball(quantity, more);
    return file ? "accepted" : file.error().text();
  }
  // Distances from a list of three.
  Expected<ArtefactFile> row(const std::string& list, const std::string& reference = "{ dcc = \"q\" }") {
    (void)folder_.write("c.xml", head + ("<s:realListXMLList>" + list + "</s:realListXMLList>") + tail);
    std::string text =
        "schema = \"artcal-artefact/1\"\ndcc = \"c.xml\"\nunits = { length = \"mm\" }\n"
        "[[distance]]\nalong = [\"A\", \"B\", \"C\", \"D\"]\npositions = " +
        reference + "\n";
    for (const char* name : {"A", "B", "C", "D"}) {
      text += std::string("[[feature]]\nname = \"") + name + "\"\nkind = \"point\"\n";
    }
    return read_artefact_file(folder_.write("row.toml", text));
  }
  testing::TemporaryFolder folder_;
};

TEST_F(DccLength, TakesTheUncertaintyFromWhicheverRepresentationHasIt) {
  const std::string metre = real("0.0254", "\\metre"), inch = real("1", "\\inch");
  const std::string millimetre = real("25.4", "\\milli\\metre", expanded("0.00254"));
  for (const std::string& order : {metre + millimetre, millimetre + metre, inch + millimetre}) {
    EXPECT_DOUBLE_EQ(u_diameter(hybrid(order)), 0.00127) << order;
    EXPECT_DOUBLE_EQ(diameter(hybrid(order)), 25.4) << order;
  }
  EXPECT_DOUBLE_EQ(u_diameter(hybrid(real("0.0254", "\\metre", expanded("2.54e-6")) + real("25.4", "\\milli\\metre"))),
                   0.00127)
      << "converted with its own unit";
}

TEST_F(DccLength, TakesTheRepresentationWithTheMostDigits) {
  EXPECT_DOUBLE_EQ(diameter(hybrid(real("0.025", "\\metre") + real("25.40012", "\\milli\\metre"))), 25.40012);
  EXPECT_DOUBLE_EQ(diameter(hybrid(real("0.02540012", "\\metre") + real("25.4", "\\milli\\metre"))), 25.40012);
}

TEST_F(DccLength, RefusesRepresentationsThatContradictEachOther) {
  EXPECT_THAT(refusal(hybrid(real("0.02541", "\\metre") + real("25.400", "\\milli\\metre"))),
              AllOf(HasSubstr("states 25.41 mm and 25.4 mm"), HasSubstr("ask the laboratory")));
  EXPECT_THAT(
      refusal(hybrid(real("0.0254", "\\metre", expanded("0.003")) + real("25.4", "\\milli\\metre", expanded("0.003")))),
      HasSubstr("U = 3 mm (k = 2) and U = 0.003 mm (k = 2)"));
  EXPECT_EQ(refusal(hybrid(real("0.0254", "\\metre", expanded("3e-6")) +
                           real("25.4", "\\milli\\metre", expanded("0.00254")))),
            "accepted")
      << "rounded to one digit";
}

TEST_F(DccLength, ReadsOneUnitForEachValue) {
  const auto file = row(
      "<s:labelXMLList>L1 L2 L3</s:labelXMLList><s:valueXMLList>100.0002 0.2000005 300001.1</s:valueXMLList>"
      "<s:unitXMLList>\\milli\\metre \\metre \\micro\\metre</s:unitXMLList><s:expandedUncXMLList><s:uncertaintyXMLList>"
      "0.0004 0.000003 6</s:uncertaintyXMLList><s:coverageFactorXMLList>2</s:coverageFactorXMLList>"
      "</s:expandedUncXMLList>");
  ASSERT_TRUE(file) << file.error().text();
  const auto& distances = file->artefact.distances;
  ASSERT_EQ(distances.size(), 3u);
  EXPECT_DOUBLE_EQ(distances[0].value, 100.0002);
  EXPECT_DOUBLE_EQ(distances[1].value, 200.0005);
  EXPECT_DOUBLE_EQ(distances[2].value, 300.0011);
  EXPECT_DOUBLE_EQ(distances[0].u, 0.0002);
  EXPECT_DOUBLE_EQ(distances[1].u, 0.0015);
  EXPECT_DOUBLE_EQ(distances[2].u, 0.003);
  EXPECT_THAT(
      row("<s:valueXMLList>1 2 3</s:valueXMLList><s:unitXMLList>\\metre \\metre</s:unitXMLList>").error().text(),
      HasSubstr("holds 3 values and 2 units"));
}

TEST_F(DccLength, ChoosesANumberByItsLabel) {
  const std::string list =
      "<s:realListXMLList><s:labelXMLList>L1 L2 L2</s:labelXMLList><s:valueXMLList>25 26 27</s:valueXMLList>"
      "<s:unitXMLList>\\milli\\metre</s:unitXMLList></s:realListXMLList>";
  (void)folder_.write("c.xml", head + list + tail);
  const auto with = [&](const std::string& item) {
    return read_artefact_file(
        folder_.write("ball.toml",
                      "schema = \"artcal-artefact/1\"\ndcc = \"c.xml\"\nunits = { length = "
                      "\"mm\" }\n[[feature]]\nname = \"A\"\nkind = \"sphere\"\ndiameter = { dcc = "
                      "\"q\", item = \"" +
                          item + "\" }\n"));
  };
  EXPECT_DOUBLE_EQ(*with("L1")->artefact.features[0].radius, 12.5);
  EXPECT_THAT(with("L2").error().text(), HasSubstr("2 of the certificate's numbers are labelled \"L2\""));
  EXPECT_THAT(with("L3").error().text(), HasSubstr("0 of the certificate's numbers are labelled \"L3\""));
}

TEST_F(DccLength, ReadsARelativeUncertainty) {
  const std::string ball_25 = real("25.4", "\\milli\\metre");
  // U = 1e-4 · 25.4 mm.
  for (const auto& [value, unit] :
       {std::pair{"1e-4", "\\one"}, std::pair{"0.01", "\\percent"}, std::pair{"100", "\\ppm"},
        std::pair{"100", "\\micro\\metre\\per\\metre"}, std::pair{"0.1", "\\milli\\metre\\metre\\tothe{-1}"}}) {
    EXPECT_THAT(u_diameter(ball_25 + relative(value, unit), "k_diameter = 2\n"), DoubleNear(0.00127, 1e-12)) << unit;
  }
  EXPECT_THAT(u_diameter(ball_25 + relative("1e-4", "\\one", "<s:coverageFactor>4</s:coverageFactor>")),
              DoubleNear(0.000635, 1e-12));
  EXPECT_THAT(
      refusal(ball_25 + relative("1e-4", "\\one")),
      AllOf(HasSubstr("a relative uncertainty, U = 0.00254 mm, without its coverage factor"), HasSubstr("`k`")));
  EXPECT_THAT(u_diameter(real("25.4", "\\milli\\metre", expanded("0.002")) + relative("1e-4", "\\one")),
              DoubleNear(0.001, 1e-12))
      << "the absolute uncertainty counts";
  EXPECT_THAT(refusal(ball_25 + relative("1e-4", "\\kelvin")), HasSubstr("in a form that is not read here"));
}

TEST_F(DccLength, SaysThatAnUncertaintyIsThereWhichIsNotRead) {
  const std::string region =
      "<s:ellipsoidalRegion><s:covarianceMatrix/><s:coverageFactor>2</s:coverageFactor></s:ellipsoidalRegion>";
  const std::string unknown =
      "<s:measurementUncertaintyUnivariate><s:newMU>1</s:newMU></s:measurementUncertaintyUnivariate>";
  const std::string multivariate =
      "<s:measurementUncertaintyMultivariate><s:covariance>1</s:covariance></s:measurementUncertaintyMultivariate>";
  for (const std::string& form : {region, unknown, multivariate}) {
    EXPECT_THAT(refusal(real("25.4", "\\milli\\metre", form)),
                AllOf(HasSubstr("states an uncertainty in a form that is not read here"), HasSubstr("(line 3)"),
                      HasSubstr("state `U_diameter` and `k_diameter` as the certificate does")))
        << form;
    EXPECT_DOUBLE_EQ(u_diameter(real("25.4", "\\milli\\metre", form), "U_diameter = 0.002\nk_diameter = 2\n"), 0.001)
        << form;
  }
  EXPECT_THAT(refusal(hybrid(real("1", "\\inch", expanded("0.0001")) + real("25.4", "\\milli\\metre"))),
              HasSubstr("an uncertainty in \"\\inch\""));
  EXPECT_EQ(u_diameter(real("25.4", "\\milli\\metre")), 0.0) << "none is stated";
}

TEST(DsiUnits, AreTakenStrictly) {
  EXPECT_EQ(dsi_length_unit("\\metre"), 1000.0);
  EXPECT_EQ(dsi_length_unit("\\milli\\metre"), 1.0);
  EXPECT_EQ(dsi_length_unit("\\micro\\metre"), 1e-3);
  EXPECT_EQ(dsi_length_unit("\\centi\\metre"), 10.0);
  for (const char* none : {"\\kelvin", "mm", "\\milli\\meter", "\\mega\\metre", "\\milli\\milli\\metre",
                           "\\metre\\tothe{2}", "\\centi\\metre\\tothe{3}", "", "metre", "\\per\\metre"}) {
    EXPECT_FALSE(dsi_length_unit(none)) << none;
    EXPECT_FALSE(dsi_ratio_unit(none)) << none;
  }
}

}  // namespace
}  // namespace artcal
