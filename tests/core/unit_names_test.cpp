#include "core/unit_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

TEST(UnitNames, KnowsLengthsAndAngles) {
  EXPECT_EQ(length_unit("mm"), 1.0);
  EXPECT_EQ(length_unit("um"), 1e-3);
  EXPECT_EQ(length_unit("µm"), 1e-3);
  EXPECT_EQ(length_unit("m"), 1e3);
  EXPECT_EQ(length_unit("in"), 25.4);
  EXPECT_EQ(angle_unit("rad"), 1.0);
  EXPECT_EQ(angle_unit("mrad"), 1e-3);
  EXPECT_EQ(angle_unit("deg"), units::degree);
  EXPECT_EQ(angle_unit("arcsec"), units::arcsecond);
}

TEST(UnitNames, KnowsNothingElse) {
  for (const char* name : {"", "MM", "mm ", "cm", "deg", "rad"}) {
    EXPECT_FALSE(length_unit(name)) << name;
  }
  for (const char* name : {"", "degree", "°", "mm", "gon"}) {
    EXPECT_FALSE(angle_unit(name)) << name;
  }
}

TEST(UnitNames, Quantities) {
  EXPECT_DOUBLE_EQ(*length_quantity("15 um"), 0.015);
  EXPECT_DOUBLE_EQ(*length_quantity("15um"), 0.015);
  EXPECT_DOUBLE_EQ(*length_quantity("1.5e-2 mm"), 0.015);
  EXPECT_DOUBLE_EQ(*angle_quantity("2 arcsec"), 2.0 * units::arcsecond);
  EXPECT_EQ(length_quantity("0 mm"), 0.0);
}

TEST(UnitNames, RefusesOddQuantities) {
  for (const char* text : {"", "mm", "15", "15 deg", "-1 um", "nan um", "inf um", "1e999 um", "1,5 um", "15 um!",
                           " 15 um", "15 um 3", "0x10 um"}) {
    EXPECT_FALSE(length_quantity(text)) << text;
  }
  EXPECT_FALSE(angle_quantity("2 mm"));
}

Expected<double> unit_in(std::string_view line, bool length) {
  const TextFile file{"f.toml", "schema = \"s\"\n[units]\n" + std::string(line), ""};
  auto document = TomlDocument::parse(file, "s");
  auto units = document->root().table("units");
  const double unit = length ? length_unit(units, "length") : angle_unit(units, "joint");
  return document->finish().map([unit] { return unit; });
}

TEST(UnitNames, TakesTheUnitFromATable) {
  EXPECT_EQ(unit_in("length = \"m\"", true).value(), 1e3);
  EXPECT_EQ(unit_in("joint = \"deg\"", false).value(), units::degree);
}

TEST(UnitNames, MissingOrUnknownUnitsAreErrors) {
  EXPECT_THAT(unit_in("", true).error().text(), HasSubstr("the unit `length` is not stated"));
  EXPECT_THAT(unit_in("length = \"furlong\"", true).error().text(),
              HasSubstr("f.toml:3:10: \"furlong\" is not a unit"));
  EXPECT_THAT(unit_in("length = 1", true).error().text(), HasSubstr("is a number, expected text"));
  EXPECT_THAT(unit_in("joint = \"mm\"", false).error().text(), HasSubstr("one of deg, rad, mrad, arcsec"));
}

TEST(UnitNames, ReadsALengthPerLength) {
  EXPECT_EQ(ratio_quantity("1.2 um/m"), 1.2e-6);
  EXPECT_EQ(ratio_quantity("1.2 µm/m"), 1.2e-6);
  EXPECT_EQ(ratio_quantity("3 ppm"), 3e-6);
  EXPECT_EQ(ratio_quantity("0.5 mm/m"), 0.5e-3);
  EXPECT_EQ(ratio_quantity("0.001 mm/mm"), 0.001);
  for (const char* none : {"1.2", "1.2 um", "-1 ppm", "um/m", "inf ppm"}) {
    EXPECT_FALSE(ratio_quantity(none)) << none;
  }
}

}  // namespace
}  // namespace artcal
