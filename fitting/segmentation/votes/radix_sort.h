#pragma once

#include <cstdint>
#include <vector>

namespace artcal::segmentation {

/// Sorts by the bits from `low` to below `high`, 0 ≤ low ≤ high ≤ 64, what is equal in these in the order it had: digit
/// by digit from the lowest, each put in its place by counting (Knuth, The Art of Computer Programming 3, 5.2.5). On
/// `threads` threads (≤ 0: as many as the machine has), which do not change the answer.
void radix_sort(std::vector<std::uint64_t>& values, int low, int high, int threads = 0);

}  // namespace artcal::segmentation
