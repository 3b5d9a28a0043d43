#pragma once

#include <string>
#include <vector>

namespace artcal {

/// What answers to the questions of `artcal new` may be.
bool is_name(const std::string& text);                            ///< one to 80 characters, none of control
bool is_count(const std::string& text, int lowest, int highest);  ///< a whole number in this range
bool is_length(const std::string& text);                          ///< with its unit, "3 mm"
bool is_angle(const std::string& text);
bool is_length_or_none(const std::string& text);  ///< above zero, or "none"
bool is_angle_or_none(const std::string& text);
bool is_path(const std::string& text);

/// The units that files take.
std::vector<std::string> length_unit_names();
std::vector<std::string> angle_unit_names();

}  // namespace artcal
