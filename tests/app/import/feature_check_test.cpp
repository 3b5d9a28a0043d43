// Points planted on a ball, in a bore and on a shaft, as centres of a tip of 1.5 mm radius: the check says what was
// planted.
#include "app/import/feature_check.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double tip = 1.5;

void add(ImportedReadings& readings, const char* name, double x, double y, double z) {
  readings.rows.push_back({name, fmt::format("{:.9f}", x), fmt::format("{:.9f}", y), fmt::format("{:.9f}", z)});
}

/// A ball of 25.4 mm about (10, 20, 30), a bore of 12 mm about (50, 0, .) along z, a shaft of 8 mm about (0, 90, .).
ImportedReadings planted() {
  ImportedReadings readings;
  readings.columns = {"feature", "x", "y", "z"};
  const double ball = 12.7 + tip;
  for (const auto& d : {Eigen::Vector3d(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0.6, 0.8, 0}}) {
    add(readings, "B", 10 + ball * d.x(), 20 + ball * d.y(), 30 + ball * d.z());
  }
  for (int i = 0; i < 12; ++i) {
    const double at = 0.5 * i;
    add(readings, "bore", 50 + (6 - tip) * std::cos(at), (6 - tip) * std::sin(at), 7.0);
    add(readings, "shaft", (4 + tip) * std::cos(at), 90 + (4 + tip) * std::sin(at), 3.0 * (i % 4));
  }
  using Kind = ReportedFeature::Kind;
  readings.reported = {{"B", Kind::Sphere, {10, 20, 30}, {0, 0, 0}, 25.4},
                       {"bore", Kind::Circle, {50, 0, -100}, {0, 0, -2}, 12},
                       {"shaft", Kind::Cylinder, {0, 90, 77}, {0, 0, 1}, 8}};
  return readings;
}

TEST(FeatureCheck, OfWhatWasUnderstoodRightIsZero) {
  EXPECT_EQ(
      feature_check(planted(), 1.0, tip),
      "  check: 3 features fitted to their points differ from the file's by at most 0.0000 mm in place, 0.0000 mm in "
      "diameter\n");
  EXPECT_EQ(feature_check({}, 1.0, tip), "");
}

TEST(FeatureCheck, ShowsWhatIsWrong) {
  ImportedReadings moved = planted();
  moved.reported[0].place.x() += 0.25;
  moved.reported[1].diameter += 0.125;
  EXPECT_THAT(feature_check(moved, 1.0, tip),
              AllOf(HasSubstr("by at most 0.2500 mm in place, 0.1250 mm in diameter"),
                    HasSubstr("check \"B\": its points say another feature, 0.2500 mm away, diameter +0.0000 mm"),
                    HasSubstr("check \"bore\": its points say another feature, 0.0000 mm away, diameter -0.1250 mm"),
                    Not(HasSubstr("\"shaft\""))));
  // The tip forgotten, the unit wrong.
  EXPECT_THAT(feature_check(planted(), 1.0, 0.0), HasSubstr("3.0000 mm in diameter"));
  ImportedReadings few = planted();
  few.rows.resize(2);
  EXPECT_THAT(feature_check(few, 1.0, tip), HasSubstr("3 features could not be fitted to their points"));
}

}  // namespace
}  // namespace artcal
