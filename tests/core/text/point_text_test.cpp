#include "core/text/point_text.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(PointText, HasAsManyDecimalsAsMatter) {
  EXPECT_EQ(decimals_text(-739120.4, 0.001), "-739120.400");
  EXPECT_EQ(decimals_text(12.3456, 0.01), "12.35");
  EXPECT_EQ(decimals_text(12.3456, 0.02), "12.35");
  EXPECT_EQ(decimals_text(1234.5, 10.0), "1234");
  EXPECT_EQ(decimals_text(-1e-9, 0.001), "0.000");
  EXPECT_EQ(point_text({1.0, -2.5, 1e6}, 0.1), "(1.0, -2.5, 1000000.0)");
}

}  // namespace
}  // namespace artcal
