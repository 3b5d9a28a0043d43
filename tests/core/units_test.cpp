#include "core/units.h"

#include <cmath>

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(Units, Angles) {
  EXPECT_DOUBLE_EQ(180.0 * units::degree, std::acos(-1.0));
  EXPECT_DOUBLE_EQ(3600.0 * units::arcsecond, units::degree);
  EXPECT_DOUBLE_EQ(1000.0 * units::milliradian, units::radian);
}

TEST(Units, Lengths) {
  EXPECT_EQ(units::metre, 1000.0 * units::millimetre);
  EXPECT_DOUBLE_EQ(1000.0 * units::micrometre, units::millimetre);
  EXPECT_EQ(units::inch, 25.4);
}

}  // namespace
}  // namespace artcal
