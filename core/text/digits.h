#pragma once

namespace artcal {

/// Whether it is one of 0 to 9, in every locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace artcal
