#include "acquisition/text_rows.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "core/in_quotes.h"

namespace artcal {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

bool to_number(std::string_view text, double& value) {
  const std::string_view digits = text.starts_with('+') && !text.starts_with("+-") ? text.substr(1) : text;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc{} && end == digits.data() + digits.size();
}

}  // namespace

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view blanks = " \t\r";
  for (std::size_t start = line.find_first_not_of(blanks); start != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, start), line.size());
    words.push_back(line.substr(start, end - start));
    start = line.find_first_not_of(blanks, end);
  }
  return words;
}

bool is_number(std::string_view text) {
  double value = 0.0;
  return to_number(text, value);
}

void TextRows::split() {
  fields_.clear();
  if (separator_ == Separator::Comma) {
    std::size_t start = 0;
    for (std::size_t comma = 0; comma != std::string_view::npos; start = comma + 1) {
      comma = line_.find(',', start);
      fields_.push_back(trimmed(line_.substr(start, comma - start)));
    }
    return;
  }
  const char* const end = line_.data() + line_.size();
  for (const char* at = line_.data(); at != end;) {
    const char* const start = at;
    while (at != end && !is_blank(*at)) {
      ++at;
    }
    fields_.emplace_back(start, static_cast<std::size_t>(at - start));
    while (at != end && is_blank(*at)) {
      ++at;
    }
  }
}

bool TextRows::next() {
  do {
    if (rest_.empty()) {
      return false;
    }
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    line_number_ = next_line_++;
    if (line_.ends_with('\r')) {
      line_.remove_suffix(1);
    }
    line_ = trimmed(line_);
  } while (line_.empty() || line_.front() == '#' || line_.starts_with("//"));
  split();
  return true;
}

Expected<void> TextRows::numbers(const std::vector<std::size_t>& columns, double* values) const {
  for (const std::size_t column : columns) {
    if (column >= fields_.size()) {
      return bad_input(fmt::format("the line has {} numbers, expected at least {}", fields_.size(), column + 1),
                       where());
    }
    if (!to_number(fields_[column], *values++)) {
      return bad_input(fmt::format("column {}: found {}, expected a number with a decimal point", column + 1,
                                   fields_[column].empty() ? "nothing" : in_quotes(fields_[column])),
                       where());
    }
  }
  return {};
}

std::string TextRows::where() const { return fmt::format("{}:{}", path_, line_number_); }

}  // namespace artcal
