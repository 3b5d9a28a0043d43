// Tables and reports of other programs, written for these tests from public descriptions of their forms; what they hold
// is stated here by hand.
#include "acquisition/import/imported_readings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/import/pcdmis_report.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TextFile text_file(const std::string& text) { return {"points.txt", text, ""}; }

std::string csv(const std::string& text, const std::string& columns = "") {
  const auto readings = import_text(text_file(text), {columns, std::nullopt, 0});
  return readings ? readings_csv(*readings) : readings.error().text();
}

TEST(ImportedText, OfEveryKindIsTheSameTable) {
  const std::string expected = "feature,x,y,z\n\"A 1\",1.50,-20.25,3\nB,0.5,0,1E-3\n";
  EXPECT_EQ(csv("name;x;y;z\nA 1;1,50;-20,25;3\nB;0,5;0;1E-3\n"), expected);
  EXPECT_EQ(csv("Name\tX [mm]\tY [mm]\tZ [mm]\r\nA 1\t1.50\t-20.25\t+3\r\nB\t0.5\t0\t1e-3\r\n"), expected);
  EXPECT_EQ(csv("# by hand\n\"A 1\",1.50,-20.25,3\nB,0.5,0,1D-3\n", "name,x,y,z"), expected);
  EXPECT_EQ(csv("\"A 1\" 1,50 -20,25   3 \n  B 0,5 0 1e-3\n", "name,x,y,z"), expected);
  EXPECT_EQ(csv("1;A 1;9;1.50;-20.25;3\n2;B;9;0.5;0;1E-3\n", "-,name,-,x,y,z"), expected);
  EXPECT_EQ(csv("z;label;y;x\n3;A 1;-20.25;1.50\n1E-3;B;0;0.5\n", "name=2,x=4,y=y,z=1"), expected);
}

TEST(ImportedText, SaysWhichColumnsWereUsed) {
  const auto readings = import_text(text_file("name;x;y;z;i;j;k\nA;1,5;2;3;0;0;1\n"), {});
  ASSERT_TRUE(readings);
  EXPECT_EQ(readings->format, "text separated by semicolons, a header, decimal commas");
  EXPECT_THAT(readings->understood,
              ElementsAre("feature = column 1, x = column 2, y = column 3, z = column 4; passed over: "
                          "\"i\", \"j\", \"k\""));
}

TEST(ImportedText, JointAnglesAreTaken) {
  EXPECT_EQ(csv("Joint1,Joint 2,angle3,x,y,z\n1,2,3,4,5,6\n"), "q1,q2,q3,x,y,z\n1,2,3,4,5,6\n");
}

TEST(ImportedText, IsRefusedWhereItIsNotUnderstood) {
  EXPECT_THAT(csv("1;2;3;4\n2;5;6;7\n"), HasSubstr("points.txt:1: the table has no header"));
  EXPECT_THAT(csv("1 10 20\n2 11 21\n3 12 22\n", "x,y,z"),
              HasSubstr("points.txt:1: the column taken for x counts the rows"));
  EXPECT_THAT(csv("a;b;c\n1;2;3\n"), HasSubstr("of x, y, z 0 are there"));
  EXPECT_THAT(csv("x;y;z\n1,5;2.5;3\n"), HasSubstr("points.txt:2:5: \"2.5\" and numbers above have decimal commas"));
  EXPECT_THAT(csv("x;y;z\n1;2;3\n1.234,5;2;3\n"), HasSubstr("points.txt:3:1: `x` is \"1.234,5\", expected a number"));
  EXPECT_THAT(csv("x;y;z\n1;2\n"), HasSubstr("points.txt:2: the row has 2 fields, expected 3"));
  EXPECT_THAT(csv("x;y;z\n1;nan;2\n"), HasSubstr("points.txt:2:3: `y` is \"nan\""));
  EXPECT_THAT(csv("x;y;z\n\"1;2;3\n"), HasSubstr("points.txt:2:1: the quote is not closed"));
  EXPECT_THAT(csv("x;x;y;z\n1;2;3;4\n"), HasSubstr("columns 1 and 2 are both `x`"));
  EXPECT_THAT(csv("A;1;2;3\n", "name,x,y"), HasSubstr("of x, y, z 2 are there"));
  EXPECT_THAT(csv("A;1;2;3\n", "name,x,y,z,q1"), HasSubstr("the file has 4 columns"));
  EXPECT_THAT(csv("x;y;z\n"), HasSubstr("a header and no rows"));
  EXPECT_THAT(csv("# nothing\n"), HasSubstr("holds no rows"));
  EXPECT_THAT(csv("x;y;z\n1e999;2;3\n"), HasSubstr("expected a number"));
}

constexpr const char* report =
    "PART NAME  : plate\n"
    "DIM LOC1= LOCATION OF SPHERE SPH1  UNITS=MM ,$\n"
    "GRAPH=OFF  TEXT=OFF  MULT=10.00  OUTPUT=BOTH\n"
    "AX    NOMINAL     +TOL     -TOL      MEAS       DEV    OUTTOL\n"
    "X     10.0000   0.0500   0.0500   10.0123    0.0123   0.0000 --#-\n"
    "Y    -20.0000   0.0500   0.0500  -20.0040   -0.0040   0.0000 -#--\n"
    "Z      5.0000   0.0500   0.0500    5.0007    0.0007   0.0000 --#-\n"
    "D     25.4000   0.0500   0.0500   25.4003    0.0003   0.0000 --#-\n"
    "END OF DIMENSION LOC1\n"
    "DIM DIST1= 2D DISTANCE FROM SPHERE SPH1 TO SPHERE SPH2\n"
    "DIM LOC2= LOCATION OF SPHERE SPH2  UNITS=MM ,$\n"
    "AX       MEAS  NOMINAL\n"
    "X     30.0100  30.0000\n"
    "Y      1.0000   1.0000\n"
    "Z      2.0000   2.0000\n"
    "END OF DIMENSION LOC2\n";

TEST(ImportedReport, TakesTheMeasuredValues) {
  ASSERT_TRUE(is_pcdmis_report(text_file(report)));
  const auto readings = import_pcdmis_report(text_file(report));
  ASSERT_TRUE(readings) << readings.error().text();
  EXPECT_EQ(readings_csv(*readings), "feature,x,y,z\nSPH1,10.0123,-20.0040,5.0007\nSPH2,30.0100,1.0000,2.0000\n");
  EXPECT_EQ(readings->length_unit, "mm");
  EXPECT_THAT(readings->understood.back(), HasSubstr("passed over: 1 x 2D, 1 x D"));
}

TEST(ImportedReport, IsRefusedWhereItIsNotUnderstood) {
  const auto refusal = [](const std::string& from, const std::string& to) {
    std::string text = report;
    text.replace(text.find(from), from.size(), to);
    return import_pcdmis_report(text_file(text)).error().text();
  };
  EXPECT_THAT(refusal("10.0123", "10.0l23"), HasSubstr("points.txt:5: X of \"SPH1\" is \"10.0l23\" under MEAS"));
  EXPECT_THAT(refusal("Z      5.0000", "W      5.0000"), HasSubstr("points.txt:2: the location of \"SPH1\" has no Z"));
  EXPECT_THAT(refusal("SPH2  UNITS=MM", "SPH2  UNITS=IN"), HasSubstr("some locations in mm and some in inches"));
  EXPECT_THAT(refusal("UNITS=MM", "UNITS=CUBIT"), HasSubstr("the unit is \"CUBIT\""));
  EXPECT_THAT(refusal("AX    NOMINAL     +TOL     -TOL      MEAS", "AX    NOMINAL     +TOL     -TOL      ACT"),
              HasSubstr("points.txt:4: the heading of the table has no MEAS"));
  EXPECT_THAT(refusal("Y    -20.0000", "X    -20.0000"), HasSubstr("points.txt:6: X of \"SPH1\" is there twice"));
}

}  // namespace
}  // namespace artcal
