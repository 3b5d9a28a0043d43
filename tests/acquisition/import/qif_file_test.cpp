// QIF documents written for these tests from the public schema of QIF 3 (qifstandards.org); what they hold is stated by
// hand.
#include "acquisition/import/qif_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TextFile text_file(const std::string& text) { return {"plate.qif", text, ""}; }

const std::string head =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<QIFDocument xmlns=\"http://qifstandards.org/xsd/qif3\" idMax=\"20\" versionQIF=\"3.0.0\">\n"
    "<FileUnits><PrimaryUnits><LinearUnit><SIUnitName>meter</SIUnitName><UnitName>mm</UnitName>"
    "<UnitConversion><Factor>0.001</Factor></UnitConversion></LinearUnit></PrimaryUnits></FileUnits>\n"
    "<Features><FeatureItems n=\"3\">\n"
    "<SphereFeatureItem id=\"3\"><FeatureName>S1</FeatureName></SphereFeatureItem>\n"
    "<CircleFeatureItem id=\"4\"><FeatureName>C 1</FeatureName></CircleFeatureItem>\n"
    "<CylinderFeatureItem id=\"5\"><FeatureName>CY</FeatureName></CylinderFeatureItem>\n"
    "</FeatureItems></Features>\n"
    "<Results><MeasurementResultsSet n=\"1\"><MeasurementResults id=\"6\">\n";

const std::string features =
    "<MeasuredFeatures n=\"3\">\n"
    "<SphereFeatureMeasurement id=\"7\"><FeatureItemId>3</FeatureItemId>\n"
    "<PointList n=\"2\"><RangePointSetId range=\"1 2\">10</RangePointSetId><SinglePointSetId "
    "index=\"4\">10</SinglePointSetId>"
    "</PointList><Location>1 2 3</Location><Diameter>25.4</Diameter></SphereFeatureMeasurement>\n"
    "<CircleFeatureMeasurement id=\"8\"><FeatureItemId>4</FeatureItemId>\n"
    "<PointList n=\"1\"><WholePointSetId>11</WholePointSetId></PointList>"
    "<Location>5 6 7.25</Location><Normal>0 0 1</Normal><Diameter>12</Diameter></CircleFeatureMeasurement>\n"
    "<CylinderFeatureMeasurement id=\"9\"><FeatureItemId>5</FeatureItemId><Axis><AxisPoint>0 0 0</AxisPoint>"
    "<Direction>0 0 1</Direction></Axis><Diameter>8</Diameter></CylinderFeatureMeasurement>\n"
    "</MeasuredFeatures>\n";

const std::string sets =
    "<MeasuredPointSets n=\"2\">\n"
    "<MeasuredPointSet id=\"10\" count=\"4\"><Points>1.50 2 3 <!-- a comment -->4 5 6\n7 8 9 10 11 12e0</Points>"
    "<Compensated>false</Compensated><ProbeRadius>1.5</ProbeRadius></MeasuredPointSet>\n"
    "<MeasuredPointSet id=\"11\" count=\"1\"><Points>20 21 22</Points>"
    "<Compensations>0</Compensations><ProbeRadii>1.5</ProbeRadii></MeasuredPointSet>\n"
    "</MeasuredPointSets>\n";

const std::string foot = "</MeasurementResults></MeasurementResultsSet></Results></QIFDocument>\n";
const std::string whole = head + features + sets + foot;

std::string csv(const std::string& text) {
  const auto readings = import_qif(text_file(text));
  return readings ? readings_csv(*readings) : readings.error().text();
}

TEST(ImportedQif, TakesThePointsOfMeasuredFeatures) {
  ASSERT_TRUE(is_qif_file(text_file(whole)));
  const auto readings = import_qif(text_file(whole));
  ASSERT_TRUE(readings) << readings.error().text();
  EXPECT_EQ(readings_csv(*readings), "feature,x,y,z\nS1,1.50,2,3\nS1,4,5,6\nS1,10,11,12E0\n\"C 1\",20,21,22\n");
  EXPECT_EQ(readings->length_unit, "mm");
  EXPECT_EQ(readings->probe_radius, "1.5");
  EXPECT_THAT(readings->understood, Contains("the points are centres of the tip"));
  EXPECT_THAT(readings->understood, Contains("passed over: 1 features without points"));
  ASSERT_THAT(readings->reported, SizeIs(2));
  EXPECT_EQ(readings->reported[1].kind, ReportedFeature::Kind::Circle);
  EXPECT_EQ(readings->reported[1].place, Eigen::Vector3d(5, 6, 7.25));
  EXPECT_EQ(readings->reported[1].diameter, 12.0);
}

TEST(ImportedQif, PrefixesAreTheWritersChoice) {
  std::string prefixed = whole;
  for (std::size_t at = 0; (at = prefixed.find('<', at)) != std::string::npos; ++at) {
    if (prefixed[at + 1] != '?' && prefixed[at + 1] != '!') {
      prefixed.insert(prefixed[at + 1] == '/' ? at + 2 : at + 1, "q:");
    }
  }
  prefixed.replace(prefixed.find("xmlns="), 6, "xmlns:q=");
  ASSERT_TRUE(is_qif_file(text_file(prefixed)));
  EXPECT_EQ(csv(prefixed), csv(whole));
}

TEST(ImportedQif, WithoutPointsTakesThePlacesOfFeatures) {
  std::string without = features;
  for (std::size_t at; (at = without.find("<PointList")) != std::string::npos;) {
    without.erase(at, without.find("</PointList>") + 12 - at);
  }
  const auto readings = import_qif(text_file(head + without + foot));
  ASSERT_TRUE(readings) << readings.error().text();
  EXPECT_EQ(readings_csv(*readings), "feature,x,y,z\nS1,1,2,3\n\"C 1\",5,6,7.25\n");
  EXPECT_EQ(readings->probe_radius, "");
}

TEST(ImportedQif, SeveralPartsAreRepeats) {
  const std::string second = "</MeasurementResults><MeasurementResults id=\"16\">\n" + features + sets;
  EXPECT_THAT(csv(head + features + sets + second + foot),
              AllOf(HasSubstr("feature,repeat,x,y,z\nS1,1,1.50,2,3\n"), HasSubstr("S1,2,1.50,2,3\n")));
}

std::string changed(const std::string& from, const std::string& to) {
  std::string text = whole;
  text.replace(text.find(from), from.size(), to);
  return csv(text);
}

TEST(ImportedQif, TipsAndUnits) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(from), from.size(), to);
    auto readings = import_qif(text_file(text));
    EXPECT_TRUE(readings) << readings.error().text();
    return readings ? *readings : ImportedReadings{};
  };
  EXPECT_EQ(with("<Factor>0.001", "<Factor>0.0254").length_unit, "in");
  EXPECT_EQ(with("<UnitConversion><Factor>0.001</Factor></UnitConversion>", "").length_unit, "m");
  EXPECT_THAT(changed("<Factor>0.001", "<Factor>0.01"), HasSubstr("plate.qif:3: the unit of lengths is 0.01 times"));
  EXPECT_THAT(changed("<ProbeRadius>1.5", "<ProbeRadius>2.5"), HasSubstr("the tip's radius is 1.5 here and 2.5"));
  EXPECT_THAT(changed("<Compensated>false", "<Compensated>true"), HasSubstr("some points are compensated"));
  EXPECT_THAT(changed("<ProbeRadii>1.5<", "<ProbeRadii>1.5 2<"), HasSubstr("tips of radius 1.5 and 2, expected one"));
  EXPECT_THAT(changed("<Compensations>0<", "<Compensations>0 1<"), HasSubstr("some are not"));
  std::string compensated = whole;
  compensated.replace(compensated.find("<Compensated>false"), 18, "<Compensated>true");
  compensated.replace(compensated.find("<Compensations>0"), 16, "<Compensations>1");
  EXPECT_EQ(import_qif(text_file(compensated))->probe_radius, "0");
}

TEST(ImportedQif, IsRefusedWhereItIsNotUnderstood) {
  EXPECT_THAT(changed("versionQIF=\"3.0.0\"", "versionQIF=\"2.1.0\""),
              HasSubstr("plate.qif:2: the document is QIF \"2.1.0\", expected QIF 3"));
  EXPECT_THAT(changed("count=\"4\"", "count=\"5\""), HasSubstr("states \"5\" points and has 12 numbers"));
  EXPECT_THAT(changed("count=\"4\"", "count=\"99999999999999999999\""), HasSubstr("points and has 12 numbers"));
  EXPECT_THAT(changed("11 12e0", "11 12e0 13"), HasSubstr("has 13 numbers, expected three a point"));
  EXPECT_THAT(changed("1.50 2 3", "1,50 2 3"), HasSubstr("plate.qif:18: \"1,50\" of Points is no number"));
  EXPECT_THAT(changed("range=\"1 2\"", "range=\"1 5\""), HasSubstr("expected some of 1 to 4"));
  EXPECT_THAT(changed("range=\"1 2\"", "range=\"0 2\""), HasSubstr("expected some of 1 to 4"));
  EXPECT_THAT(changed("index=\"4\"", "index=\"x\""), HasSubstr("expected some of 1 to 4"));
  EXPECT_THAT(changed("index=\"4\">10", "index=\"4\">12"), HasSubstr("there is no MeasuredPointSet \"12\""));
  EXPECT_THAT(changed("<Points>20 21 22</Points>", "<BinaryPoints>AAAA</BinaryPoints>"),
              HasSubstr("the set has BinaryPoints, which is not read"));
  EXPECT_THAT(changed("<Points>20", "<CoordinateSystemId>2</CoordinateSystemId><Points>20"),
              HasSubstr("a coordinate system of their own"));
  EXPECT_THAT(changed("id=\"11\" count", "id=\"11\" linearUnit=\"inch\" count"), HasSubstr("the set has the unit"));
  EXPECT_THAT(changed("<FeatureName>C 1", "<FeatureName>S1"), HasSubstr("\"S1\" is measured twice"));
  EXPECT_THAT(changed("<Location>1 2 3", "<Location>1 2"), HasSubstr("Location has 2 numbers, expected three"));
  EXPECT_THAT(changed("<QIFDocument", "<!DOCTYPE a [<!ENTITY b \"c\">]><QIFDocument"), HasSubstr("document type"));
  EXPECT_THAT(csv(head + foot), HasSubstr("no measured points and no fitted point"));
  EXPECT_THAT(csv("<QIFDocument"), HasSubstr("not valid XML"));
}

// A list that names a whole set ten thousand times.
TEST(ImportedQif, FeaturesCannotNameMorePointsThanTheFileHolds) {
  std::string text = whole;
  const std::string one = "<WholePointSetId>11</WholePointSetId>";
  std::string many, points;
  for (int i = 0; i < 1000; ++i) {
    many += one;
    points += "1 2 3 ";
  }
  text.replace(text.find(one), one.size(), many);
  text.replace(text.find("20 21 22"), 8, points);
  text.replace(text.find("id=\"11\" count=\"1\""), 17, "id=\"11\" count=\"1000\"");
  EXPECT_THAT(csv(text), HasSubstr("the features name more points together than the file can hold"));
}

}  // namespace
}  // namespace artcal
