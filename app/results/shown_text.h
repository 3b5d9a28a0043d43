#pragma once

#include <cstddef>
#include <string>

namespace artcal {

/// Lengths in mm to 0.1 um; a value that there is none of, such as a deviation by an arm that cannot be evaluated, is
/// NaN and shown as "-".
std::string mm_text(double value);
std::string signed_mm_text(double value);

/// Names come from files and may be longer than a screen is wide.
std::string shown_name(const std::string& name, std::size_t most = 60);

}  // namespace artcal
