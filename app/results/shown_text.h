#pragma once

#include <cstddef>
#include <string>

namespace artcal {

/// Lengths in mm to 0.1 um; a value that there is none of, such as a deviation by an arm that cannot be evaluated, is
/// NaN and shown as "-".
std::string mm_text(double value);
std::string signed_mm_text(double value);
/// Of a deviation: with its sign where it has one, as from a ball's surface or a plane; a distance from a point has
/// none.
std::string deviation_text(double value, bool is_signed);

/// Names come from files and may be longer than a screen is wide.
std::string shown_name(const std::string& name, std::size_t most = 60);

}  // namespace artcal
