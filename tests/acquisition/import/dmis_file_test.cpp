// DMIS files written for these tests from the public description of the language (ANSI/DMSC 105.0: F(…) is a nominal
// feature, FA(…) an actual one, $$ begins a comment, $ joins lines); no sample with a licence was found. What they hold
// is stated by hand.
#include "acquisition/import/dmis_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/import/dmis_statement.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TextFile text_file(const std::string& text) { return {"plate.dmo", text, ""}; }

std::string csv(const std::string& text, bool points = false) {
  const auto readings = import_dmis(text_file(text), points);
  return readings ? readings_csv(*readings) : readings.error().text();
}

TEST(DmisStatements, AreSplit) {
  const auto all = dmis_statements(
      "$$ heading\nDMISMN/'part, $$ no comment',05.2 $$ comment\r\n\nFA(Sph 1) = Feat/Sphere,outer,CART, 1.5 ,$\n  "
      "-2,3,$\n"
      "25.4\nMEAS/POINT, F(P1), 1\nENDMES\n");
  ASSERT_THAT(all, SizeIs(4));
  EXPECT_EQ(all[0].line, 2);
  EXPECT_THAT(all[0].fields, ElementsAre("'part, $$ no comment'", "05.2"));
  EXPECT_EQ(all[1].line, 4);
  EXPECT_EQ(all[1].label_kind, "FA");
  EXPECT_EQ(all[1].label, "Sph 1");
  EXPECT_EQ(all[1].major, "FEAT");
  EXPECT_THAT(all[1].fields, ElementsAre("SPHERE", "OUTER", "CART", "1.5", "-2", "3", "25.4"));
  EXPECT_EQ(all[2].line, 7);
  EXPECT_EQ(name_in(all[2].fields[1], "F"), "P1");
  EXPECT_EQ(all[3].major, "ENDMES");
}

const std::string results =
    "FILNAM/'plate',05.2\n"
    "UNITS/MM,ANGDEC\n"
    "F(S1)=FEAT/SPHERE,OUTER,CART,0,0,0,25.4\n"
    "FA(S1)=FEAT/SPHERE,OUTER,CART,0.0012,-0.0034,0.5000,25.4003\n"
    "FA(S2)=FEAT/SPHERE,CART,100.01,0,0,25.4\n"
    "FA(C1)=FEAT/CIRCLE,INNER,CART,1,2,3,0,0,1,12.5\n"
    "FA(P1)=FEAT/POINT,CART,7,8,9,0,0,1\n"
    "FA(PL)=FEAT/PLANE,CART,0,0,0,0,0,1\n"
    "FA(CY)=FEAT/CYLNDR,INNER,CART,5,5,0,0,0,1,8\n"
    "TA(T1)=TOL/CORTOL,XAXIS,0.0012,INTOL\n"
    "ENDFIL\n";

TEST(ImportedDmis, TakesThePlacesOfActualFeatures) {
  ASSERT_TRUE(is_dmis_file(text_file(results)));
  const auto readings = import_dmis(text_file(results), false);
  ASSERT_TRUE(readings) << readings.error().text();
  EXPECT_EQ(readings_csv(*readings), "feature,x,y,z\nS1,0.0012,-0.0034,0.5000\nS2,100.01,0,0\nC1,1,2,3\nP1,7,8,9\n");
  EXPECT_EQ(readings->length_unit, "mm");
  EXPECT_THAT(readings->understood.back(), HasSubstr("passed over: 1 x CYLNDR, 1 x PLANE, 1 nominal features"));
  EXPECT_THAT(readings->reported, IsEmpty()) << "there are no points to check them by";
}

const std::string measured =
    "UNITS/INCH,ANGDEC\n"
    "PRCOMP/OFF\n"
    "F(P1)=FEAT/POINT,CART,1,2,3,0,0,1\n"
    "MEAS/POINT,F(P1),1\n"
    "PTMEAS/CART,1.0001,2,3.0002,0,0,1\n"
    "ENDMES\n"
    "F(S1)=FEAT/SPHERE,OUTER,CART,10,0,0,1\n"
    "MEAS/SPHERE,F(S1),2\n"
    "PTMEAS/CART,10,0,0.5001,0,0,1\n"
    "PTMEAS/CART,10.5002,0,0\n"
    "ENDMES\n";

TEST(ImportedDmis, TakesPointsThatAreSaidToBeMeasured) {
  const auto readings = import_dmis(text_file(measured + "FA(S1)=FEAT/SPHERE,OUTER,CART,10,0,0,1.0002\n"), true);
  ASSERT_TRUE(readings) << readings.error().text();
  EXPECT_EQ(readings_csv(*readings), "feature,x,y,z\nP1,1.0001,2,3.0002\nS1,10,0,0.5001\nS1,10.5002,0,0\n");
  EXPECT_EQ(readings->length_unit, "in");
  EXPECT_EQ(readings->probe_radius, "") << "PRCOMP/OFF does not say which tip";
  ASSERT_THAT(readings->reported, SizeIs(1));
  EXPECT_EQ(readings->reported[0].name, "S1");
  EXPECT_EQ(readings->reported[0].diameter, 1.0002);
  std::string compensated = measured;
  compensated.replace(compensated.find("OFF"), 3, "ON");
  EXPECT_EQ(import_dmis(text_file(compensated), true)->probe_radius, "0");
}

TEST(ImportedDmis, TargetsOfAProgramAreNoResults) {
  EXPECT_THAT(csv(measured),
              HasSubstr("its 3 PTMEAS may be the targets of a program; if they are measured points, say so "
                        "with --measured-points"));
  EXPECT_THAT(csv("F(P1)=FEAT/POINT,CART,1,2,3,0,0,1\n"), HasSubstr("1 nominal features F(…) and no actual one"));
  std::string targets = measured;
  targets.replace(targets.find("1.0001,2,3.0002"), 15, "1.000,2,3.0");
  EXPECT_THAT(csv(targets, true), HasSubstr("are their nominal features F(…) digit by digit"));
  EXPECT_THAT(csv(results, true), HasSubstr("no PTMEAS between MEAS and ENDMES"));
}

TEST(ImportedDmis, IsRefusedWhereItIsNotUnderstood) {
  const auto changed = [](std::string text, const std::string& from, const std::string& to, bool points = false) {
    text.replace(text.find(from), from.size(), to);
    return csv(text, points);
  };
  EXPECT_THAT(changed(results, "UNITS/MM", "UNITS/CM"), HasSubstr("plate.dmo:2: the unit of lengths is \"CM\""));
  EXPECT_THAT(changed(results, "ENDFIL", "UNITS/INCH"), HasSubstr("plate.dmo:11: UNITS states another unit"));
  EXPECT_THAT(changed(results, "-0.0034", "-0.0O34"), HasSubstr("plate.dmo:4: y of \"S1\" is \"-0.0O34\", expected a"));
  EXPECT_THAT(changed(results, "POINT,CART,7,8,9", "POINT,POL,7,8,9"),
              HasSubstr("plate.dmo:7: FEAT \"P1\" has polar coordinates (POL)"));
  EXPECT_THAT(changed(results, "POINT,CART,7,8,9,0,0,1", "POINT,CART,7,8"), HasSubstr("has 2 numbers behind CART"));
  EXPECT_THAT(changed(results, "FA(P1)", "FA()"), HasSubstr("plate.dmo:7: the feature's name is empty"));
  // Coordinates of two coordinate systems in one recording.
  for (const char* change :
       {"D(A)=DATSET/DAT(B)\n", "D(A)=ROTATE/ZAXIS,30\n", "RECALL/D(A)\n", "d(a)=trans/xorig,5\n"}) {
    EXPECT_THAT(changed(results, "FA(C1)", change + std::string("FA(C1)")), HasSubstr("plate.dmo:6: ")) << change;
    EXPECT_THAT(changed(results, "FA(C1)", change + std::string("FA(C1)")),
                HasSubstr("changes the coordinate system between \"S1\" and \"C1\""))
        << change;
    EXPECT_THAT(changed(results, "FA(S1)", change + std::string("FA(S1)")), HasSubstr("feature,x,y,z")) << change;
  }
  EXPECT_THAT(changed(results, "FA(C1)", "PRCOMP/ON\nFA(C1)"), HasSubstr("PRCOMP changes between \"S1\" and \"C1\""));
  EXPECT_THAT(changed(measured, "F(S1),2", "F(S1),3", true),
              HasSubstr("plate.dmo:8: MEAS of \"S1\" states 3 points, 2 PTMEAS follow"));
  EXPECT_THAT(changed(measured, "MEAS/POINT,F(P1),1\n", "", true), HasSubstr("plate.dmo:4: PTMEAS stands outside"));
  EXPECT_THAT(changed(measured, "MEAS/POINT,F(P1),1", "MEAS/POINT,1", true), HasSubstr("MEAS names no feature"));
}

}  // namespace
}  // namespace artcal
