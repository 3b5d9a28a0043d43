#include "core/text/decimal_comma.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/text/trimmed.h"

namespace artcal {
namespace {

constexpr std::string_view digits = "0123456789";

// Where the comma stands in "-3,5" or "3,5e-2 mm": digits, one comma, digits, and no point.
std::size_t decimal_comma(std::string_view text) {
  const std::size_t begin = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const std::size_t comma = text.find_first_not_of(digits, begin);
  if (comma == begin || comma == std::string_view::npos || text[comma] != ',') {
    return std::string_view::npos;
  }
  const std::size_t end = std::min(text.find_first_not_of(digits, comma + 1), text.size());
  const bool is_number = end > comma + 1 && (end == text.size() || (text[end] != ',' && text[end] != '.'));
  return is_number ? comma : std::string_view::npos;
}

}  // namespace

std::string decimal_comma_question(std::string_view text) {
  const std::string_view number = trimmed(text);
  const std::size_t comma = decimal_comma(number);
  if (comma == std::string_view::npos) {
    return {};
  }
  std::string with_point(number);
  with_point[comma] = '.';
  return fmt::format("; is the comma a decimal comma? Write {} with a point: {}", in_quotes(number),
                     truncated(40, with_point));
}

std::string decimal_comma_question_of_line(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) {
    return {};
  }
  const std::string_view value = line.substr(equals + 1);
  return decimal_comma_question(value.substr(0, value.find('#')));
}

}  // namespace artcal
