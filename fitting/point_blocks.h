#pragma once

#include <cstddef>
#include <vector>

#include "core/parallel.h"

namespace artcal::fitting {

/// Many points are passed over in blocks of so many, side by side.
constexpr std::size_t points_of_a_block = std::size_t{1} << 16u;

/// What of(begin, end) gives for each block of [0, count), in the order of the blocks: sums added in that order have
/// the same digits on one thread and on many.
template <typename Result, typename Of>
std::vector<Result> of_each_block(std::size_t count, const Of& of) {
  std::vector<Result> results((count + points_of_a_block - 1) / points_of_a_block);
  parallel_blocks(count, points_of_a_block,
                  [&](std::size_t begin, std::size_t end) { results[begin / points_of_a_block] = of(begin, end); });
  return results;
}

}  // namespace artcal::fitting
