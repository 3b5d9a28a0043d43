#include "acquisition/recording/reading_fingerprint.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "core/random.h"

namespace artcal {
namespace {

Recording recording_of(int readings, std::uint64_t seed) {
  Recording recording;
  RandomStream random(seed, "fingerprints");
  recording.joints = Eigen::MatrixXd::NullaryExpr(6, readings, [&] { return random.uniform(-3.0, 3.0); });
  return recording;
}

// printf '1000000 -2000000 0 ' | sha256sum
TEST(ReadingFingerprint, IsTheHashOfWholeMicroradians) {
  EXPECT_EQ(reading_fingerprint(Eigen::Vector3d(1.0, -2.0, -1e-8)), "bbfa5a23e625");
  EXPECT_EQ(reading_fingerprint(Eigen::Vector3d(1.0 + 4e-7, -2.0, 0.0)), "bbfa5a23e625");
  EXPECT_NE(reading_fingerprint(Eigen::Vector3d(1.0 + 6e-7, -2.0, 0.0)), "bbfa5a23e625");
  // printf '10000000000000000 0 -2000000000 ' | sha256sum
  EXPECT_EQ(reading_fingerprint(Eigen::Vector3d(1e10, -1e-7, -2000.0)), "49d3ae64e2d5");
  EXPECT_EQ(reading_fingerprint(Eigen::Vector3d(1.0, NAN, 0.0)), "");
  EXPECT_EQ(reading_fingerprint(Eigen::VectorXd()), "");
}

TEST(ReadingFingerprint, SharedReadingsAreCounted) {
  const Recording identified = recording_of(300, 1);
  const auto known = fingerprints_of(identified, {});
  ASSERT_EQ(known.size(), 300u);
  EXPECT_TRUE(std::is_sorted(known.begin(), known.end()));
  EXPECT_EQ(count_known(identified, known), 300);
  EXPECT_EQ(count_known(recording_of(300, 2), known), 0);
  Recording mixed = recording_of(100, 2);
  mixed.joints.rightCols(40) = identified.joints.middleCols(7, 40);
  EXPECT_EQ(count_known(mixed, known), 40);
  // Readings behind the arm that it started from stay known.
  EXPECT_EQ(count_known(identified, fingerprints_of(recording_of(50, 3), known)), 300);
}

// 10,000 readings: 4,096 fingerprints are kept, and of any 500 some 205 are found (binomial: s = 11).
TEST(ReadingFingerprint, ASampleStandsForManyReadings) {
  const Recording identified = recording_of(10'000, 1);
  const auto known = fingerprints_of(identified, {});
  ASSERT_EQ(known.size(), max_fingerprints);
  Recording some = identified;
  some.joints = identified.joints.middleCols(4'000, 500).eval();
  EXPECT_NEAR(count_known(some, known), 205, 55);
}

}  // namespace
}  // namespace artcal
