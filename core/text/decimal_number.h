#pragma once

#include <optional>
#include <string_view>

namespace artcal {

/// The number that a text is, from its first character to its last, as files write numbers in every locale: digits with
/// or without a point, an exponent, a minus or one plus before them. "nan" and "inf" are numbers here, since some
/// formats mark what was not measured so: who wants a quantity asks is_in_range() as well (core/number_range.h).
/// Nothing where the text is empty, has blanks, a comma, a unit or a second sign, is hexadecimal, or lies outside of
/// what a double holds: "1e400" and "1e-400" are no numbers.
std::optional<double> decimal_number(std::string_view text);

}  // namespace artcal
