#pragma once

#include <algorithm>
#include <ranges>

namespace artcal {

/// Whether `value` is among the elements, which are compared one by one.
template <std::ranges::input_range Range, typename Value>
bool contains(const Range& elements, const Value& value) {
  return std::ranges::find(elements, value) != std::ranges::end(elements);
}

}  // namespace artcal
