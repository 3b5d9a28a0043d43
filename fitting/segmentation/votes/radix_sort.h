#pragma once

#include <cstdint>
#include <vector>

namespace artcal::segmentation {

struct Keyed {
  std::uint64_t key;
  std::uint32_t index;
};

/// Sorts by key; what has the same key keeps its order. Time goes with the count (radix sort, digits that
/// all have in common are passed over).
void sort_by_key(std::vector<Keyed>& items);

}  // namespace artcal::segmentation
