#include "fitting/segmentation/votes/radix_sort.h"

#include <algorithm>
#include <utility>

#include "core/large_pages.h"
#include "core/parallel.h"

namespace artcal::segmentation {
namespace {

constexpr int max_digit_bits = 10;  // more places than that are too many for the caches to write to
constexpr std::size_t values_of_block = std::size_t{1} << 16u;  // values that are put in their places together

}  // namespace

void radix_sort(std::vector<std::uint64_t>& values, int low, int high, int threads) {
  const int digits = (high - low + max_digit_bits - 1) / max_digit_bits;
  const std::size_t blocks = (values.size() + values_of_block - 1) / values_of_block;
  auto sorted = large_vector<std::uint64_t>(digits > 0 ? values.size() : 0);
  std::vector<std::size_t> places;
  for (int digit = 0; digit < digits; ++digit) {
    const int begin = low + (high - low) * digit / digits;
    const int end = low + (high - low) * (digit + 1) / digits;
    const std::size_t count = std::size_t{1} << static_cast<unsigned>(end - begin);
    const auto digit_of = [&](std::uint64_t value) { return static_cast<std::size_t>(value >> begin) & (count - 1); };
    places.assign(blocks * count, 0);  // how many a block has of each, and then where its next one goes
    parallel_for(blocks, threads, [&](std::size_t block) {
      const std::size_t last = std::min(values.size(), (block + 1) * values_of_block);
      for (std::size_t i = block * values_of_block; i < last; ++i) {
        ++places[block * count + digit_of(values[i])];
      }
    });
    std::size_t next = 0;
    for (std::size_t of_digit = 0; of_digit < count; ++of_digit) {
      for (std::size_t block = 0; block < blocks; ++block) {
        next += std::exchange(places[block * count + of_digit], next);
      }
    }
    parallel_for(blocks, threads, [&](std::size_t block) {
      const std::size_t last = std::min(values.size(), (block + 1) * values_of_block);
      for (std::size_t i = block * values_of_block; i < last; ++i) {
        sorted[places[block * count + digit_of(values[i])]++] = values[i];
      }
    });
    values.swap(sorted);
  }
}

}  // namespace artcal::segmentation
