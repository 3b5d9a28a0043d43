#include "fitting/segmentation/votes/radix_sort.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace artcal::segmentation {
namespace {

TEST(RadixSort, IsAStableSortByTheBitsAsked) {
  std::mt19937_64 random(3);
  for (const std::size_t size : {0u, 1u, 2u, 1000u, 65'536u, 200'001u}) {
    for (const auto& [low, high] : {std::pair{0, 64}, {0, 1}, {23, 43}, {40, 64}, {7, 7}, {5, 16}}) {
      std::vector<std::uint64_t> values(size);
      std::generate(values.begin(), values.end(), random);
      auto expected = values;
      const std::uint64_t mask = high - low == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << (high - low)) - 1;
      std::stable_sort(expected.begin(), expected.end(), [&, low = low](std::uint64_t a, std::uint64_t b) {
        return ((a >> low) & mask) < ((b >> low) & mask);
      });
      for (const int threads : {0, 1, 5}) {
        auto sorted = values;
        radix_sort(sorted, low, high, threads);
        ASSERT_TRUE(sorted == expected) << size << " values, bits " << low << " to " << high << ", " << threads;
      }
    }
  }
}

}  // namespace
}  // namespace artcal::segmentation
