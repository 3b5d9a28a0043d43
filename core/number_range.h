#pragma once

#include <cmath>

namespace artcal {

/// No quantity is larger, in whatever unit: such a number neither leaves what a double holds when its unit is taken
/// into account, nor when it is squared.
inline constexpr double largest_number = 1e100;

/// Whether a number that stands in a file may be a quantity; not infinite, NaN or beyond `largest_number`.
inline bool is_in_range(double number) { return std::abs(number) <= largest_number; }

}  // namespace artcal
