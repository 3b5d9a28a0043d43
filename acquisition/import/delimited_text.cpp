#include "acquisition/import/delimited_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "core/number_range.h"
#include "core/text/digits.h"
#include "core/text/in_quotes.h"
#include "core/text/trimmed.h"

namespace artcal {
namespace {

constexpr std::size_t max_fields = 1000;
constexpr std::string_view blanks = " \t";

bool is_comma_number(std::string_view word) {
  bool comma = false, point = false;
  return number_text(word, comma, point) && comma;
}

// "1,5 2,5 3,5" has decimal commas between blanks.
bool has_commas_in_numbers_only(std::string_view line) {
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    if (word.find(',') != std::string_view::npos && !is_comma_number(word)) {
      return false;
    }
    begin = line.find_first_not_of(blanks, end);
  }
  return line.find_first_of(blanks) != std::string_view::npos;
}

Delimiter delimiter_of(std::string_view line) {
  return line.find(';') != std::string_view::npos                                        ? Delimiter::Semicolon
         : line.find('\t') != std::string_view::npos                                     ? Delimiter::Tab
         : line.find(',') != std::string_view::npos && !has_commas_in_numbers_only(line) ? Delimiter::Comma
                                                                                         : Delimiter::Blanks;
}

/// Takes the fields of a line one by one.
class LineSplitter {
 public:
  LineSplitter(const TextFile& file, int line, std::string_view text, Delimiter delimiter)
      : path_(file.path.string()), line_(line), text_(text), delimiter_(delimiter) {}

  Expected<DelimitedRow> row() {
    DelimitedRow row;
    row.line = line_;
    do {
      const std::size_t begin = std::min(text_.find_first_not_of(around(), at_), text_.size());
      row.columns.push_back(column_of(begin));
      auto field = text_.substr(begin).starts_with('"') ? quoted(begin) : plain(begin);
      if (!field) {
        return tl::unexpected(field.error());
      }
      row.fields.push_back(std::move(*field));
      if (row.fields.size() > max_fields) {
        return bad_input(fmt::format("the row has more than {} fields", max_fields),
                         fmt::format("{}:{}", path_, line_));
      }
    } while (to_next_field());
    return row;
  }

 private:
  [[nodiscard]] char separator() const {
    return delimiter_ == Delimiter::Semicolon ? ';' : delimiter_ == Delimiter::Tab ? '\t' : ',';
  }
  [[nodiscard]] std::string_view around() const { return delimiter_ == Delimiter::Tab ? " " : blanks; }
  [[nodiscard]] int column_of(std::size_t byte) const {
    return static_cast<int>(character_count(text_.substr(0, byte))) + 1;
  }
  [[nodiscard]] std::size_t end_of_field(std::size_t from) const {
    const std::size_t end =
        delimiter_ == Delimiter::Blanks ? text_.find_first_of(blanks, from) : text_.find(separator(), from);
    return std::min(end, text_.size());
  }

  Expected<std::string> plain(std::size_t begin) {
    at_ = end_of_field(begin);
    return std::string(trimmed(text_.substr(begin, at_ - begin)));
  }

  Expected<std::string> quoted(std::size_t begin) {
    std::string field;
    for (std::size_t i = begin + 1; i < text_.size(); ++i) {
      if (text_[i] != '"') {
        field += text_[i];
      } else if (i + 1 < text_.size() && text_[i + 1] == '"') {
        field += text_[++i];
      } else {
        at_ = end_of_field(i + 1);
        if (!trimmed(text_.substr(i + 1, at_ - i - 1)).empty()) {
          return bad_input("text stands behind a closing quote, expected the next field",
                           fmt::format("{}:{}:{}", path_, line_, column_of(i + 1)));
        }
        return field;
      }
    }
    return bad_input("the quote is not closed on this line", fmt::format("{}:{}:{}", path_, line_, column_of(begin)));
  }

  bool to_next_field() {
    if (delimiter_ == Delimiter::Blanks) {
      at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
      return at_ < text_.size();
    }
    return at_++ < text_.size();
  }

  std::string path_;
  int line_;
  std::string_view text_;
  Delimiter delimiter_;
  std::size_t at_ = 0;
};

}  // namespace

std::string_view name_of(Delimiter delimiter) {
  return delimiter == Delimiter::Semicolon ? "semicolons"
         : delimiter == Delimiter::Tab     ? "tabs"
         : delimiter == Delimiter::Comma   ? "commas"
                                           : "blanks";
}

Expected<DelimitedText> split_text(const TextFile& file, std::optional<Delimiter> delimiter, int skipped) {
  DelimitedText table;
  const std::string_view text = file.text;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    const std::string_view bare = trimmed(line);
    if (++number <= skipped || bare.empty() || bare.front() == '#') {
      continue;
    }
    if (!delimiter) {
      delimiter = delimiter_of(bare);
    }
    const std::string_view without_return = line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
    auto row = LineSplitter(file, number, without_return, *delimiter).row();
    if (!row) {
      return tl::unexpected(row.error());
    }
    if (!table.rows.empty() && row->fields.size() != table.rows.front().fields.size()) {
      return bad_input(
          fmt::format("the row has {} fields, expected {} as in line {}; if lines above the table are no part of "
                      "it, pass over them with --skip",
                      row->fields.size(), table.rows.front().fields.size(), table.rows.front().line),
          fmt::format("{}:{}", file.path.string(), number));
    }
    table.rows.push_back(std::move(*row));
  }
  if (table.rows.empty()) {
    return bad_input("the file holds no rows", file.path.string());
  }
  table.delimiter = *delimiter;
  return table;
}

std::optional<std::string> number_text(std::string_view field, bool& has_comma, bool& has_point) {
  std::string text;
  std::size_t digits = 0, i = 0;
  bool comma = false, point = false;
  if (i < field.size() && (field[i] == '+' || field[i] == '-')) {
    text += field[i++] == '-' ? "-" : "";
  }
  for (; i < field.size() && (is_digit(field[i]) || field[i] == '.' || field[i] == ','); ++i) {
    if (is_digit(field[i])) {
      ++digits;
      text += field[i];
      continue;
    }
    if (comma || point) {
      return std::nullopt;
    }
    (field[i] == ',' ? comma : point) = true;
    text += '.';
  }
  if (digits == 0) {
    return std::nullopt;
  }
  if (i < field.size()) {
    if (std::string_view("eEdD").find(field[i]) == std::string_view::npos) {
      return std::nullopt;
    }
    text += 'E';
    std::size_t exponent = ++i;
    if (exponent < field.size() && (field[exponent] == '+' || field[exponent] == '-')) {
      text += field[exponent++];
    }
    const std::string_view power = field.substr(exponent);
    if (power.empty() || power.size() > 3 || !std::all_of(power.begin(), power.end(), is_digit)) {
      return std::nullopt;
    }
    text += power;
  }
  if (!is_in_range(std::strtod(text.c_str(), nullptr))) {
    return std::nullopt;
  }
  has_comma = has_comma || comma;
  has_point = has_point || point;
  return text;
}

}  // namespace artcal
