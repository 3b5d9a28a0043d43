#include "acquisition/point_cloud/text_rows.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include <fmt/format.h>

#include "core/parallel.h"
#include "core/text/decimal_number.h"
#include "core/text/in_quotes.h"
#include "core/text/trimmed.h"

namespace artcal {
namespace {

// What one thread reads at once, and how many of these are read before their numbers are handed on.
constexpr std::size_t block_size = std::size_t{1} << 19;
constexpr std::size_t max_blocks = 32;
constexpr std::size_t worth_threads = 2 * block_size;

// Whole lines from the front of a text that is not empty.
std::vector<std::string_view> first_blocks(std::string_view text) {
  std::vector<std::string_view> blocks;
  while (blocks.size() < max_blocks && !text.empty()) {
    const std::size_t end = text.find('\n', std::min(block_size, text.size()) - 1);
    blocks.push_back(text.substr(0, end == std::string_view::npos ? end : end + 1));
    text.remove_prefix(blocks.back().size());
  }
  return blocks;
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

bool is_digit_or_point(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '+' || c == '-'; }

// Characters of numbers alone: a decimal comma, an exponent out of range. They give nothing away.
bool is_numeric(std::string_view text) {
  return text.find_first_not_of("0123456789.,+-eE \t") == std::string_view::npos;
}

bool to_plain_number(std::string_view text, double& value) {
  const auto number = decimal_number(text);
  value = number.value_or(value);
  return number.has_value();
}

// The text with one character, there once, replaced by another; empty where it is not there once, or too long for a
// number.
std::string replaced_once(std::string_view text, std::string_view any_of, char by) {
  constexpr std::size_t longest = 64;
  const std::size_t at = text.find_first_of(any_of);
  if (text.size() > longest || at == std::string_view::npos ||
      text.find_first_of(any_of, at + 1) != std::string_view::npos) {
    return {};
  }
  std::string replaced(text);
  replaced[at] = by;
  return replaced;
}

// Plain first: what follows is rare, and a scan has millions of numbers.
bool to_number(std::string_view text, double& value, bool comma_is_decimal = false) {
  if (to_plain_number(text, value)) {
    return true;
  }
  std::string rewritten;
  if (comma_is_decimal && text.find('.') == std::string_view::npos) {
    rewritten = replaced_once(text, ",", '.');
  }
  if (!rewritten.empty() && to_plain_number(rewritten, value)) {
    return true;
  }
  const std::string exponent = replaced_once(rewritten.empty() ? text : std::string_view(rewritten), "dD", 'e');
  return !exponent.empty() && is_digit_or_point(exponent.front()) && to_plain_number(exponent, value);
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

std::optional<std::size_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size() && !text.empty();
  return whole ? std::optional(static_cast<std::size_t>(value)) : std::nullopt;
}

void TextRows::separate_by(Separator separator) {
  separator_ = separator;
  split();
}

void TextRows::split() {
  fields_.clear();
  if (separator_ != Separator::Blanks) {
    const char sign = separator_ == Separator::Comma ? ',' : ';';
    std::size_t start = 0;
    for (std::size_t comma = 0; comma != std::string_view::npos; start = comma + 1) {
      comma = line_.find(sign, start);
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
    ends_open_ = end == std::string_view::npos && !line_.empty() && !is_blank(line_.back()) && line_.back() != '\r';
    if (line_.ends_with('\r')) {
      line_.remove_suffix(1);
    }
    line_ = trimmed(line_);
  } while (line_.empty() || line_.front() == '#' || line_.starts_with("//"));
  split();
  return true;
}

bool TextRows::decimal_signs_agree(std::string_view field) {
  has_points_ = has_points_ || field.find('.') != std::string_view::npos;
  has_commas_ = has_commas_ || field.find(',') != std::string_view::npos;
  return !(has_points_ && has_commas_);
}

bool TextRows::is_number_at(std::size_t column) const {
  double value = 0.0;
  return to_number(fields_[column], value, separator_ == Separator::Semicolon);
}

Expected<void> TextRows::numbers(const std::vector<std::size_t>& columns, double* values) {
  const bool comma_is_decimal = separator_ == Separator::Semicolon;
  for (const std::size_t column : columns) {
    if (column >= fields_.size()) {
      return bad_input(fmt::format("the line has {} {}, expected at least {}", fields_.size(),
                                   fields_.size() == 1 ? "column" : "columns", column + 1),
                       where());
    }
    const std::string_view field = fields_[column];
    if (!to_number(field, *values++, comma_is_decimal)) {
      return bad_input(
          fmt::format("column {}: found {}, expected a number with a decimal {}", column + 1,
                      field.empty() ? "nothing" : shown(field), comma_is_decimal ? "point or comma" : "point"),
          where());
    }
    if (comma_is_decimal && !decimal_signs_agree(field)) {
      return bad_input(fmt::format("column {}: found {}, but the file has decimal points and decimal commas; expected "
                                   "one of them and no signs that group thousands",
                                   column + 1, in_quotes(field)),
                       where());
    }
  }
  watch_.row(fields_.back(), ends_open_);
  quotes_ = true;
  return {};
}

std::vector<double> TextRows::take_many(const std::vector<std::size_t>& columns, std::size_t width,
                                        std::size_t max_rows, int threads) {
  // Decimal signs agree, and numbers are cut off, in view of all rows.
  if (rest_.size() < worth_threads || rest_.size() > many_from_ || separator_ == Separator::Semicolon ||
      watch_.watches()) {
    return {};
  }
  const std::vector<std::string_view> blocks = first_blocks(rest_);
  std::string_view left = rest_;
  for (const std::string_view block : blocks) {
    left.remove_prefix(block.size());
  }
  struct Block {
    std::vector<double> numbers;
    int lines = 0;
    bool is_plain = true;
  };
  std::vector<Block> read(blocks.size());
  parallel_for(blocks.size(), threads, [&](std::size_t b) {
    TextRows rows(blocks[b], path_, 1, separator_);
    Block block;  // its neighbours' lines of the cache are other threads'
    block.numbers.reserve(static_cast<std::size_t>(std::count(blocks[b].begin(), blocks[b].end(), '\n')) *
                          columns.size());
    std::vector<double> row(columns.size());
    while (block.is_plain && rows.next()) {
      block.is_plain = rows.fields().size() == width && rows.numbers(columns, row.data()).has_value();
      block.numbers.insert(block.numbers.end(), row.begin(), row.end());
    }
    block.lines = rows.next_line() - 1;
    read[b] = std::move(block);
  });
  std::size_t size = 0;
  bool are_plain = true;
  for (const Block& block : read) {
    size += block.numbers.size();
    are_plain = are_plain && block.is_plain;
  }
  if (!are_plain || size > max_rows * columns.size()) {
    many_from_ = left.size();
    return {};
  }
  std::vector<double> numbers;
  numbers.reserve(size);
  for (const Block& block : read) {
    numbers.insert(numbers.end(), block.numbers.begin(), block.numbers.end());
    next_line_ += block.lines;
  }
  line_number_ = next_line_ - 1;
  rest_ = left;
  quotes_ = true;
  return numbers;
}

std::string TextRows::shown(std::string_view field) const {
  return quotes_ || is_numeric(field) ? in_quotes(field) : "other text";
}

std::string TextRows::where() const { return fmt::format("{}:{}", path_, line_number_); }

}  // namespace artcal
