#include "fitting/segmentation/votes/radix_sort.h"

#include <array>

namespace artcal::segmentation {

void sort_by_key(std::vector<Keyed>& items) {
  constexpr int digit_bits = 11;
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  std::vector<Keyed> sorted(items.size());
  for (int shift = 0; shift < 64; shift += digit_bits) {
    const auto digit = [shift](const Keyed& item) { return (item.key >> shift) & (digits - 1); };
    std::array<std::size_t, digits> place{};
    for (const Keyed& item : items) {
      ++place[digit(item)];
    }
    if (!items.empty() && place[digit(items.front())] == items.size()) {
      continue;
    }
    std::size_t next = 0;
    for (std::size_t& count : place) {
      const std::size_t here = count;
      count = next;
      next += here;
    }
    for (const Keyed& item : items) {
      sorted[place[digit(item)]++] = item;
    }
    items.swap(sorted);
  }
}

}  // namespace artcal::segmentation
