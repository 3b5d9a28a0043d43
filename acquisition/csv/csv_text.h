#pragma once

#include <string>
#include <string_view>

namespace artcal {

/// A label as one field of CSV, so that the reader of readings gives it back unchanged: in quotes where blanks, commas
/// or a # would be taken for something else, and with an apostrophe before it where a spreadsheet would run it as a
/// formula
/// ("=1+1", "@SUM", "-x").
std::string csv_field(std::string_view label);

/// A label as it was before csv_field() guarded it: without the apostrophe before a formula.
std::string_view without_guard(std::string_view field);

}  // namespace artcal
