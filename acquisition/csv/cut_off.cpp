#include "acquisition/csv/cut_off.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "core/text/decimal_number.h"
#include "core/text/digits.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

std::size_t digits_in(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_digit));
}

// Nothing where the text is no number.
std::optional<WrittenDigits> written_digits(std::string_view text) {
  if (!decimal_number(text)) {
    return std::nullopt;
  }
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min(text.find('.'), e);
  return WrittenDigits{digits_in(text.substr(0, e)), digits_in(text.substr(point, e - point)),
                       digits_in(text.substr(e))};
}

// A column of whole numbers is judged by all digits; one with decimals or exponents by these.
bool is_shorter(const WrittenDigits& last, const WrittenDigits& fewest) {
  if (fewest.decimals == 0 && fewest.exponent == 0) {
    return last.all < fewest.all;
  }
  return last.decimals < fewest.decimals || last.exponent < fewest.exponent;
}

}  // namespace

void CutOffWatch::note(std::string_view last_field, bool is_open) {
  if (is_open) {
    is_open_ = true;
    last_ = last_field;
  } else if (const auto digits = written_digits(last_field); digits && digits->all > 0) {  // not nan
    ++numbers_above_;
    fewest_.all = std::min(fewest_.all, digits->all);
    fewest_.decimals = std::min(fewest_.decimals, digits->decimals);
    fewest_.exponent = std::min(fewest_.exponent, digits->exponent);
  }
}

Expected<std::vector<std::string>> CutOffWatch::judge(const std::string& where) const {
  if (!is_open_) {
    return std::vector<std::string>{};
  }
  const auto digits = last_.empty() ? WrittenDigits{} : written_digits(last_);
  if (numbers_above_ > 0 && digits && is_shorter(*digits, fewest_)) {
    return bad_input(
        fmt::format("the last line has no line end, and {} in its last column has fewer digits than every number above "
                    "it; the file was probably cut off: copy it again, or add the line end if the number is complete",
                    last_.empty() ? "nothing" : truncated(40, last_)),
        where);
  }
  return std::vector{fmt::format(
      "{}: the last line has no line end; if the file was cut off there, its last value is incomplete", where)};
}

}  // namespace artcal
