#include "core/text/decimal_number.h"

#include <charconv>

namespace artcal {

std::optional<double> decimal_number(std::string_view text) {
  // from_chars knows no plus sign; what follows one must not be a sign.
  if (text.starts_with('+') && !text.starts_with("+-")) {
    text.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace artcal
