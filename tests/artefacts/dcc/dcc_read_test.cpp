// Certificates of PTB's (tests/reference/dcc), and what they must not be able to do.
#include <cmath>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/dcc/dcc_read.h"
#include "artefacts/dcc/dcc_select.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::replaced;

const std::filesystem::path samples = std::filesystem::path(ARTCAL_SOURCE_DIR) / "tests" / "reference" / "dcc";

DccCertificate sample(const std::string& name) {
  const auto certificate = read_dcc_file(samples / name);
  EXPECT_TRUE(certificate) << certificate.error().text();
  return certificate ? *certificate : DccCertificate{};
}

TEST(DccSamples, SiliconSphereOf240) {
  const DccCertificate certificate = sample("siliziumkugel_2_4_0.xml");
  EXPECT_EQ(certificate.schema_version, "2.4.0");
  EXPECT_EQ(certificate.certificate.number, "PTB - 11129 18");
  EXPECT_EQ(certificate.certificate.laboratory, "Physikalisch-Technische Bundesanstalt (PTB)");
  EXPECT_EQ(certificate.certificate.date, "2018-10-12");
  EXPECT_EQ(certificate.item, "Silicon sphere");
  EXPECT_FALSE(certificate.is_signed);
  ASSERT_EQ(certificate.quantities.size(), 2u) << "texts and ambient conditions do not count";
  const DccQuantity mass = find_quantity(certificate, "mass").value();
  EXPECT_EQ(mass.numbers().values.at(0), 1.00007841);
  EXPECT_EQ(mass.numbers().units.at(0), "\\kilogram");
  EXPECT_EQ(mass.numbers().uncertainties.at(0).U, 5e-8);
  EXPECT_EQ(mass.numbers().uncertainties.at(0).k, 2.0);
  EXPECT_EQ(mass.numbers().uncertainties.at(0).probability, 0.95);
  const DccQuantity volume = find_quantity(certificate, "Volumen bei t = 20 °C").value();
  EXPECT_EQ(volume.numbers().values.at(0), 431.055119);
  EXPECT_EQ(volume.numbers().units.at(0), "\\centi\\metre\\tothe{3}");
  EXPECT_EQ(volume.numbers().uncertainties.at(0).U, 1.8e-5);
  EXPECT_EQ(find_quantity(certificate, "Volume/Volumen bei t = 20 °C").value().line, volume.line);
}

TEST(DccSamples, ACopyThatBreaksItsSchemaElsewhereSaysTheSame) {
  EXPECT_EQ(find_quantity(sample("siliziumkugel_wrong_schema.xml"), "mass").value().numbers().values.at(0), 1.00007841);
}

TEST(DccSamples, TemperatureSensorsOf3) {
  for (const auto& [name, version, is_signed] :
       {std::tuple{"dcc_gp_temperature_typical_v12.xml", "3.1.1", false},
        std::tuple{"dcc_gp_temperature_typical_v12_v3.2.0_signed.xml", "3.2.0", true}}) {
    const DccCertificate certificate = sample(name);
    EXPECT_EQ(certificate.schema_version, version);
    EXPECT_EQ(certificate.is_signed, is_signed);
    EXPECT_EQ(certificate.certificate.laboratory, "Kalibrierfirma GmbH");
    EXPECT_EQ(certificate.certificate.date, "1957-08-13");
    ASSERT_EQ(certificate.quantities.size(), 3u) << "limits of conformity are no results";
    const DccQuantity error = find_quantity(certificate, "basic_measurementError").value();
    EXPECT_THAT(error.numbers().values, ElementsAre(0.072, 0.089, 0.107, -0.009, -0.084));
    EXPECT_EQ(error.numbers().units.at(0), "\\kelvin");
    ASSERT_EQ(error.numbers().uncertainties.size(), 5u) << "one for all";
    EXPECT_EQ(error.numbers().uncertainties[4].U, 0.061);
    EXPECT_EQ(error.numbers().uncertainties[4].k, 2.0);
    const DccQuantity reference = find_quantity(certificate, "gp_table1/basic_referenceValue").value();
    EXPECT_THAT(reference.numbers().values, ElementsAre(306.248, 373.121, 448.253, 523.319, 593.154))
        << "the first of the hybrid";
    ASSERT_EQ(reference.representations.size(), 2u);
    EXPECT_EQ(reference.representations[1].units.at(0), "\\degreecelsius");
    EXPECT_EQ(reference.numbers().units.at(0), "\\kelvin");
    EXPECT_TRUE(reference.numbers().uncertainties.empty());
  }
}

// A small certificate of our own, with something in place of its one number.
std::string certificate_with(const std::string& number, const std::string& prolog = "",
                             const std::string& version = "3.3.0") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + prolog +
         "<d:digitalCalibrationCertificate xmlns:d=\"https://ptb.de/dcc\" xmlns:s=\"https://ptb.de/si\" "
         "schemaVersion=\"" +
         version +
         "\">\n<d:administrativeData><d:coreData><d:uniqueIdentifier>N1</d:uniqueIdentifier>"
         "<d:endPerformanceDate>2026-03-02</d:endPerformanceDate></d:coreData></d:administrativeData>\n"
         "<d:measurementResults><d:measurementResult><d:results><d:result><d:data>\n" +
         number + "\n</d:data></d:result></d:results></d:measurementResult></d:measurementResults>\n" +
         "</d:digitalCalibrationCertificate>\n";
}

std::string real(const std::string& rest) {
  return "<d:quantity id=\"q\"><s:real><s:value>25.4</s:value><s:unit>\\milli\\metre</s:unit>" + rest +
         "</s:real></d:quantity>";
}

class DccTest : public ::testing::Test {
 protected:
  Expected<DccCertificate> read(const std::string& text) { return read_dcc_file(folder_.write("c.xml", text)); }
  std::string refusal(const std::string& text) {
    const auto certificate = read(text);
    return certificate ? "accepted" : certificate.error().text().substr(folder_.path().string().size() + 1);
  }
  // Why the one quantity of a certificate is not read.
  std::string fault(const std::string& quantity) {
    const auto certificate = read(certificate_with(quantity));
    EXPECT_TRUE(certificate) << certificate.error().text();
    const auto found = find_quantity(*certificate, "q");
    return found ? "read" : found.error().text().substr(folder_.path().string().size() + 1);
  }
  DccUncertainty uncertainty(const std::string& rest) {
    const auto certificate = read(certificate_with(real(rest)));
    EXPECT_TRUE(certificate) << certificate.error().text();
    return certificate ? certificate->quantities.at(0).numbers().uncertainties.at(0) : DccUncertainty{};
  }
  testing::TemporaryFolder folder_;
};

TEST_F(DccTest, ReadsEveryFormOfUncertainty) {
  const auto old = uncertainty(
      "<s:expandedUnc><s:uncertainty>4e-4</s:uncertainty><s:coverageFactor>2</s:coverageFactor>"
      "<s:coverageProbability>0.95</s:coverageProbability></s:expandedUnc>");
  EXPECT_EQ(old.U, 4e-4);
  EXPECT_EQ(old.k, 2.0);
  const auto expanded = uncertainty(
      "<s:measurementUncertaintyUnivariate><s:expandedMU><s:valueExpandedMU> +6E-4 "
      "</s:valueExpandedMU><s:coverageFactor>"
      "3</s:coverageFactor><s:coverageProbability>0.99</s:coverageProbability></s:expandedMU>"
      "</s:measurementUncertaintyUnivariate>");
  EXPECT_EQ(expanded.U, 6e-4);
  EXPECT_EQ(expanded.k, 3.0);
  EXPECT_EQ(expanded.probability, 0.99);
  const auto standard = uncertainty(
      "<s:measurementUncertaintyUnivariate><s:standardMU><s:valueStandardMU>2e-4</s:valueStandardMU></s:standardMU>"
      "</s:measurementUncertaintyUnivariate>");
  EXPECT_EQ(standard.U, 2e-4);
  EXPECT_EQ(standard.k, 1.0);
  const auto interval = uncertainty(
      "<s:coverageInterval><s:standardUnc>1e-4</s:standardUnc><s:intervalMin>25.39</s:intervalMin><s:intervalMax>25.41"
      "</s:intervalMax><s:coverageProbability>0.95</s:coverageProbability></s:coverageInterval>");
  EXPECT_EQ(interval.U, 1e-4);
  EXPECT_EQ(interval.k, 1.0);
}

TEST_F(DccTest, ReadsListsOfBothGenerations) {
  for (const char* form :
       {"<s:expandedUncXMLList><s:uncertaintyXMLList>1e-4 2e-4</s:uncertaintyXMLList><s:coverageFactorXMLList>2"
        "</s:coverageFactorXMLList></s:expandedUncXMLList>",
        "<s:measurementUncertaintyUnivariateXMLList><s:expandedMUXMLList><s:valueExpandedMUXMLList>1e-4 2e-4"
        "</s:valueExpandedMUXMLList><s:coverageFactorXMLList>2 2</s:coverageFactorXMLList></s:expandedMUXMLList>"
        "</s:measurementUncertaintyUnivariateXMLList>"}) {
    const auto certificate =
        read(certificate_with("<d:quantity><s:realListXMLList><s:valueXMLList>1.5 NaN</s:valueXMLList>"
                              "<s:unitXMLList>\\metre</s:unitXMLList>" +
                              std::string(form) + "</s:realListXMLList></d:quantity>"));
    ASSERT_TRUE(certificate) << certificate.error().text();
    const DccNumbers& quantity = certificate->quantities.at(0).numbers();
    EXPECT_EQ(quantity.values.at(0), 1.5);
    EXPECT_TRUE(std::isnan(quantity.values.at(1)));
    EXPECT_EQ(quantity.uncertainties.at(1).U, 2e-4);
    EXPECT_EQ(quantity.uncertainties.at(1).k, 2.0);
  }
}

std::string written(const std::string& value, const std::string& unit = "<s:unit>\\metre</s:unit>") {
  return "<d:quantity id=\"q\"><s:real><s:value>" + value + "</s:value>" + unit + "</s:real></d:quantity>";
}

TEST_F(DccTest, DoesNotReadNumbersThatAreNone) {
  EXPECT_THAT(fault(written("25,4")), AllOf(HasSubstr("c.xml:5: "), HasSubstr("holds \"25,4\", expected a number")));
  for (const char* value : {"", "1 2", "inf", "0x10", "1e999", "1<s:b>2</s:b>", "&one;"}) {
    EXPECT_NE(fault(written(value)), "read") << value;
  }
  EXPECT_THAT(fault(written("1", "")), HasSubstr("holds 1 values and 0 units"));
  EXPECT_THAT(fault(written("1", "<s:unit>\\metre</s:unit><s:value>2</s:value>")),
              HasSubstr("holds \"s:value\" twice"));
  EXPECT_THAT(fault(real("<s:expandedUnc><s:uncertainty>4e-4</s:uncertainty></s:expandedUnc>")),
              HasSubstr("the uncertainty holds 1 values and 0 coverage factors for 1 numbers"));
  EXPECT_THAT(fault(real("<s:expandedUnc><s:uncertainty>4e-4</s:uncertainty><s:coverageFactor>0</s:coverageFactor>"
                         "</s:expandedUnc>")),
              HasSubstr("coverage factor that is not above zero"));
  EXPECT_THAT(fault("<d:quantity id=\"q\"><s:complex/></d:quantity>"),
              HasSubstr("holds \"s:complex\", which is not read"));
}

TEST_F(DccTest, OneQuantityThatIsNotReadDoesNotKeepTheOthersFromBeingRead) {
  const auto certificate =
      read(certificate_with(replaced(written("<0.5"), "<0", "&lt;0") + replaced(real(""), "\"q\"", "\"r\"")));
  ASSERT_TRUE(certificate) << certificate.error().text();
  EXPECT_EQ(find_quantity(*certificate, "r").value().numbers().values.at(0), 25.4);
  EXPECT_FALSE(find_quantity(*certificate, "q"));
  EXPECT_THAT(list_of_quantities(*certificate), AllOf(HasSubstr("(id q) (not read: "), HasSubstr("(id r) = 25.4")));
}

// XML 1.0, 2.4 and 2.5: comments, processing instructions and the marks of CDATA are no character data. Expected
// values: xmllint --xpath "string(…)" of the same elements.
TEST_F(DccTest, TakesEveryPieceOfAText) {
  for (const char* value : {"1000<!-- mm -->.0078", "<!-- a -->1000.0078", "10<![CDATA[00.00]]>78",
                            "1000<?note x?>.0078", " 1000.00<!--a--><!--b-->78 ", "&#49;000.0078"}) {
    const auto certificate = read(certificate_with(written(value)));
    ASSERT_TRUE(certificate) << certificate.error().text();
    const auto quantity = find_quantity(*certificate, "q");
    ASSERT_TRUE(quantity) << value << quantity.error().text();
    EXPECT_EQ(quantity->numbers().values.at(0), 1000.0078) << value;
  }
  const auto list = read(certificate_with(
      "<d:quantity id=\"q\"><s:realListXMLList><s:valueXMLList>1 2<!-- a --> <!-- b -->3</s:valueXMLList>"
      "<s:unitXMLList>\\milli\\metre</s:unitXMLList><s:expandedUncXMLList><s:uncertaintyXMLList>4e-4 <!-- far -->\n "
      "3e-3 "
      "<![CDATA[6e-3]]></s:uncertaintyXMLList><s:coverageFactorXMLList>2</s:coverageFactorXMLList></"
      "s:expandedUncXMLList>"
      "</s:realListXMLList></d:quantity>"));
  const DccNumbers numbers = find_quantity(*list, "q").value().numbers();
  EXPECT_THAT(numbers.values, ElementsAre(1.0, 2.0, 3.0)) << "the blank between two comments separates 2 from 3";
  ASSERT_EQ(numbers.uncertainties.size(), 3u);
  EXPECT_EQ(numbers.uncertainties[1].U, 3e-3);
  EXPECT_EQ(numbers.uncertainties[2].U, 6e-3);
}

TEST_F(DccTest, FindsNamesThatAreBrokenOverLinesAndNamesInLabels) {
  const auto certificate = read(certificate_with(
      "<d:quantity><d:name><d:content lang=\"en\">diameter\n      of <!-- first -->ball A</d:content></d:name>"
      "<s:real><s:value>1</s:value><s:unit>\\metre</s:unit></s:real></d:quantity>"
      "<d:quantity><s:real><s:label>length\n "
      "2</s:label><s:value>2</s:value><s:unit>\\metre</s:unit></s:real></d:quantity>"
      "<d:quantity><s:hybrid><s:real><s:label>third</s:label><s:value>3</s:value><s:unit>\\metre</s:unit></s:real>"
      "</s:hybrid></d:quantity>"));
  EXPECT_EQ(find_quantity(*certificate, "diameter of ball A").value().numbers().values.at(0), 1.0);
  EXPECT_EQ(find_quantity(*certificate, "diameter of\nball A").value().numbers().values.at(0), 1.0);
  EXPECT_EQ(find_quantity(*certificate, "length 2").value().numbers().values.at(0), 2.0);
  EXPECT_EQ(find_quantity(*certificate, "third").value().numbers().values.at(0), 3.0);
}

TEST_F(DccTest, ReadsListsOfSingleNumbers) {
  const auto certificate = read(certificate_with(
      "<d:quantity id=\"q\"><s:list><s:realList><s:listUnit>\\milli\\metre</s:listUnit><s:listUnivariateUnc>"
      "<s:expandedUnc><s:uncertainty>1e-3</s:uncertainty><s:coverageFactor>2</s:coverageFactor></s:expandedUnc>"
      "</s:listUnivariateUnc><s:real><s:value>1</s:value></s:real><s:real><s:value>2</s:value>"
      "<s:unit>\\micro\\metre</s:unit><s:measurementUncertaintyUnivaraite><s:standardMU><s:valueStandardMU>2e-3"
      "</s:valueStandardMU></s:standardMU></s:measurementUncertaintyUnivaraite></s:real></s:realList></s:list>"
      "</d:quantity>"));
  const auto quantity = find_quantity(*certificate, "q");
  ASSERT_TRUE(quantity) << quantity.error().text();
  EXPECT_THAT(quantity->numbers().values, ElementsAre(1.0, 2.0));
  EXPECT_THAT(quantity->numbers().units, ElementsAre("\\milli\\metre", "\\micro\\metre"));
  ASSERT_EQ(quantity->numbers().uncertainties.size(), 2u);
  EXPECT_EQ(quantity->numbers().uncertainties[0].k, 2.0);
  EXPECT_EQ(quantity->numbers().uncertainties[1].k, 1.0);
}

TEST_F(DccTest, NamesTheQuantitiesThereAreWhereTheOneAskedForIsNot) {
  const auto certificate = read(certificate_with(real("")));
  EXPECT_THAT(find_quantity(*certificate, "diameter").error().text(),
              AllOf(HasSubstr("has no quantity \"diameter\"; it has: "), HasSubstr("(id q) = 25.4 \\milli\\metre")));
  const auto empty = read(certificate_with(""));
  ASSERT_TRUE(empty);
  EXPECT_THAT(find_quantity(*empty, "diameter").error().text(), HasSubstr("and no other with a number"));
  const std::string two = "<d:list id=\"A\">" + replaced(real(""), " id=\"q\"", " refType=\"d\"") +
                          "</d:list><d:list id=\"B\">" + replaced(real(""), " id=\"q\"", " refType=\"d\"") +
                          "</d:list>";
  const auto same = read(certificate_with(two));
  EXPECT_THAT(find_quantity(*same, "d").error().text(), HasSubstr("2 quantities of the certificate"));
  EXPECT_EQ(find_quantity(*same, "A/d").value().within.back()->id, "A");
  EXPECT_EQ(find_quantity(*same, "B/d").value().within.back()->id, "B");
  EXPECT_FALSE(find_quantity(*same, "C/d"));
}

TEST_F(DccTest, RefusesWhatIsNoCertificate) {
  EXPECT_THAT(refusal("<html></html>"), HasSubstr("this is no digital calibration certificate: its root is \"html\""));
  EXPECT_THAT(refusal(replaced(certificate_with(""), "https://ptb.de/dcc", "https://example.org/dcc")),
              HasSubstr("expected digitalCalibrationCertificate of https://ptb.de/dcc"));
  EXPECT_THAT(refusal(certificate_with("", "", "1.0")), HasSubstr("schemaVersion is \"1.0\", expected 2.x or 3.x"));
  EXPECT_THAT(refusal(certificate_with("").substr(0, 400)), HasSubstr("this is not valid XML"));
  EXPECT_THAT(refusal(replaced(certificate_with(""), "2026-03-02", "2026-02-31")),
              HasSubstr("endPerformanceDate is \"2026-02-31\", expected a day of the calendar"));
  EXPECT_THAT(refusal("not XML"), HasSubstr("this is"));
}

TEST_F(DccTest, RefusesDocumentTypesAndSoEntities) {
  EXPECT_THAT(refusal(certificate_with(real(""), "<!DOCTYPE x [<!ENTITY a SYSTEM \"file:///etc/passwd\">]>\n")),
              AllOf(HasSubstr("c.xml:2: "), HasSubstr("the file has a document type")));
  std::string laughs = "<!DOCTYPE lolz [<!ENTITY a0 \"ha\">";
  for (int i = 1; i < 12; ++i) {
    const std::string inner = "&a" + std::to_string(i - 1) + ";";
    laughs += "<!ENTITY a" + std::to_string(i) + " \"";
    for (int j = 0; j < 10; ++j) {
      laughs += inner;
    }
    laughs += "\">";
  }
  EXPECT_THAT(refusal(certificate_with("<d:quantity>&a11;</d:quantity>", laughs + "]>\n")), HasSubstr("document type"));
  // An entity that nobody defined stays the text it is.
  EXPECT_THAT(fault(written("&one;")), HasSubstr("holds \"&one;\", expected a number"));
}

TEST_F(DccTest, RefusesDeepNesting) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) {
      text += "<d:list>";
    }
    text += real("");
    for (int i = 0; i < depth; ++i) {
      text += "</d:list>";
    }
    return certificate_with(text);
  };
  EXPECT_EQ(refusal(nested(40)), "accepted");
  EXPECT_THAT(refusal(nested(100)), HasSubstr("elements are nested more than 64 deep"));
  EXPECT_THAT(refusal(nested(500000)), HasSubstr("elements are nested more than 64 deep"));
}

TEST_F(DccTest, RefusesOtherEncodingsAndGiantFiles) {
  EXPECT_THAT(refusal(replaced(certificate_with(""), "UTF-8", "ISO-8859-1")),
              HasSubstr("its encoding is \"ISO-8859-1\""));
  EXPECT_THAT(refusal(replaced(certificate_with(""), "N1", "N\xe9")), HasSubstr("is not UTF-8"));
  EXPECT_THAT(refusal(std::string("\xff\xfe<\0?\0", 6)), HasSubstr("zero bytes"));
  EXPECT_THAT(refusal(certificate_with("<!--" + std::string(std::size_t{17} << 20, 'x') + "-->")),
              HasSubstr("split it"));
}

TEST_F(DccTest, ShowsHostileNamesHarmlessly) {
  const auto certificate = read(replaced(certificate_with(real("")), "id=\"q\"", "id=\"&#27;[2J&lt;script&gt;\""));
  ASSERT_TRUE(certificate) << certificate.error().text();
  const std::string message = find_quantity(*certificate, "x").error().text();
  EXPECT_EQ(message.find('\x1b'), std::string::npos);
  EXPECT_THAT(message, HasSubstr("?[2J<script>"));
}

}  // namespace
}  // namespace artcal
