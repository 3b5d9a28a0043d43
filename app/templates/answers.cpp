#include "app/templates/answers.h"

#include <charconv>

#include "core/files/size_limits.h"
#include "core/text/in_quotes.h"
#include "core/unit_names.h"

namespace artcal {

bool is_name(const std::string& text) {
  constexpr std::size_t longest = 80;
  return !text.empty() && character_count(text) <= longest && !find_control(text);
}

bool is_count(const std::string& text, int lowest, int highest) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && value >= lowest && value <= highest;
}

bool is_length(const std::string& text) { return length_quantity(text).has_value(); }

bool is_angle(const std::string& text) { return angle_quantity(text).has_value(); }

bool is_length_or_none(const std::string& text) { return text == "none" || length_quantity(text).value_or(0.0) > 0.0; }

bool is_angle_or_none(const std::string& text) { return text == "none" || angle_quantity(text).value_or(0.0) > 0.0; }

bool is_path(const std::string& text) { return !text.empty() && text.size() <= largest::path; }

std::vector<std::string> length_unit_names() { return {"mm", "um", "m", "in"}; }

std::vector<std::string> angle_unit_names() { return {"deg", "rad", "mrad", "arcsec"}; }

}  // namespace artcal
