#include "app/report/thinning.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A wave of many points with two that stand out, in no order.
struct Wave {
  std::vector<double> x, y;
  explicit Wave(int count) {
    for (int i = 0; i < count; ++i) {
      const int shuffled = static_cast<int>((i * 7919LL) % count);
      x.push_back(shuffled);
      y.push_back(std::sin(0.01 * shuffled));
    }
  }
};

TEST(Thinning, FewPointsAreAllKept) { EXPECT_THAT(thinned({3, 1, 2}, {0, 0, 0}, 8), ElementsAre(0, 1, 2)); }

TEST(Thinning, PointsThatAreNoNumbersAreLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(thinned({1, nan, 3}, {1, 2, nan}, 8), ElementsAre(0));
  EXPECT_THAT(thinned({}, {}, 8), IsEmpty());
}

TEST(Thinning, ManyBecomeNoMoreThanAsked) {
  const Wave wave(100'003);
  const auto kept = thinned(wave.x, wave.y, 2400);
  EXPECT_LE(kept.size(), 2400u);
  EXPECT_GT(kept.size(), 2000u);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(std::adjacent_find(kept.begin(), kept.end()), kept.end());
}

TEST(Thinning, NoExtremeIsLost) {
  Wave wave(100'003);
  wave.y[5] = 40.0;
  wave.y[77'777] = -40.0;
  const auto kept = thinned(wave.x, wave.y, 100);
  EXPECT_THAT(kept, Contains(5));
  EXPECT_THAT(kept, Contains(77'777));
}

TEST(Thinning, EveryStretchKeepsPoints) {
  const Wave wave(10'000);
  std::vector<int> tenths(10);
  for (const int i : thinned(wave.x, wave.y, 200)) {
    ++tenths[static_cast<std::size_t>(wave.x[i] / 1000.0)];
  }
  EXPECT_GE(*std::min_element(tenths.begin(), tenths.end()), 10);
}

}  // namespace
}  // namespace artcal
