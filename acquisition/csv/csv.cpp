#include "acquisition/csv/csv.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <fmt/format.h>

#include "core/number_range.h"
#include "core/text/decimal_comma.h"
#include "core/text/decimal_number.h"
#include "core/text/in_quotes.h"
#include "core/text/trimmed.h"

namespace artcal {
namespace {}  // namespace

Expected<CsvReader> CsvReader::open(const TextFile& file, const HeaderKind& kind) {
  CsvReader reader(file);
  const auto found = reader.read_row();
  if (!found) {
    return tl::unexpected(found.error());
  }
  if (!*found) {
    return bad_input("the file has no header line, expected column names such as placement,feature,q1,q2",
                     reader.path_);
  }
  reader.header_.assign(reader.fields_.begin(), reader.fields_.end());
  if (auto checked = reader.check_header(kind); !checked) {
    return tl::unexpected(checked.error());
  }
  return reader;
}

Expected<void> CsvReader::check_header(const HeaderKind& kind) {
  if (header_.size() == 1 && (row_.find(';') != std::string_view::npos || row_.find('\t') != std::string_view::npos)) {
    return bad_input("the columns are separated by semicolons or tabs, expected commas (and a point in numbers)",
                     where(0));
  }
  if (const std::string wrong = kind(header_); !wrong.empty()) {
    return bad_input(wrong, where(0));
  }
  std::unordered_set<std::string_view> known;
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (header_[i].empty()) {
      return bad_input("a column has no name", where(i));
    }
    if (!known.insert(header_[i]).second) {
      return bad_input(fmt::format("the column {} is there twice", in_quotes(header_[i])), where(i));
    }
  }
  return {};
}

std::optional<std::size_t> CsvReader::column(std::string_view name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  return found == header_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - header_.begin()));
}

std::string CsvReader::where(std::size_t column) const {
  return where_byte(column < starts_.size() ? starts_[column] : 0);
}

std::string CsvReader::where_line() const { return fmt::format("{}:{}", path_, line_); }

std::string CsvReader::where_byte(std::size_t offset) const {
  return fmt::format("{}:{}:{}", path_, line_, character_count(row_.substr(0, offset)) + 1);
}

// A quoted field may hold commas and doubled quotes, but no line end: no label has one, and a quote left
// open would otherwise swallow the rest of the file.
Expected<void> CsvReader::read_field() {
  const auto start = fields_.empty() ? 0 : starts_.back();
  const std::string_view rest = row_.substr(start);
  std::size_t i = rest.find_first_not_of(" \t");
  std::size_t end = rest.find(',');
  std::string_view field;
  if (i != std::string_view::npos && rest[i] == '"') {
    std::string& text = unquoted_.emplace_back();
    for (++i; i < rest.size(); ++i) {
      if (rest[i] != '"') {
        text += rest[i];
      } else if (i + 1 < rest.size() && rest[i + 1] == '"') {
        text += rest[++i];
      } else {
        break;
      }
    }
    end = rest.find(',', std::min(i, rest.size()));
    const std::string_view tail = i < rest.size() ? rest.substr(i + 1, end - i - 1) : std::string_view{};
    if (i >= rest.size() || !trimmed(tail).empty()) {
      return bad_input("a quoted field is not closed, or something follows its closing quote", where_byte(start));
    }
    field = text;
  } else {
    field = trimmed(rest.substr(0, end));
  }
  fields_.push_back(field);
  starts_.push_back(end == std::string_view::npos ? row_.size() + 1 : start + end + 1);
  return {};
}

Expected<bool> CsvReader::read_row() {
  do {
    if (rest_.empty()) {
      return false;
    }
    const std::size_t end = rest_.find('\n');
    row_ = rest_.substr(0, end);
    ends_open_ = end == std::string_view::npos && !row_.empty() && trimmed(row_.substr(row_.size() - 1)) != "" &&
                 row_.back() != '"';
    row_.remove_suffix(row_.size() - row_.find_last_not_of(" \t\r") - 1);  // npos + 1 is 0: all blank
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    line_ = next_line_++;
  } while (row_.empty() || row_.front() == '#');
  if (const auto control = find_control(row_)) {
    return bad_input(fmt::format("there is a control character (code {}), expected plain text with lines that end in "
                                 "LF or CR LF",
                                 control->code),
                     where_byte(control->offset));
  }
  fields_.clear();
  starts_.clear();
  unquoted_.clear();
  do {
    if (auto read = read_field(); !read) {
      return tl::unexpected(read.error());
    }
  } while (starts_.back() <= row_.size());
  // starts_ holds where each field's successor begins; shift it to where the field itself does.
  starts_.insert(starts_.begin(), 0);
  starts_.pop_back();
  return true;
}

Expected<bool> CsvReader::next() {
  auto found = read_row();
  if (found && *found) {
    watch_.row(fields_.back(), ends_open_);
  }
  if (found && *found && fields_.size() != header_.size()) {
    return bad_input(
        fmt::format("the line has {} fields, expected {} as in the header{}", fields_.size(), header_.size(),
                    fields_.size() > header_.size() ? "; are there decimal commas? Numbers have points here" : ""),
        where(0));
  }
  return found;
}

Expected<double> CsvReader::number(std::size_t column, std::string_view expected) const {
  const std::string_view text = field(column);
  const auto value = decimal_number(text);
  if (!value || !is_in_range(*value)) {
    return bad_input(fmt::format("column {}: found {}, expected {}{}", header_[column],
                                 text.empty() ? "nothing" : in_quotes(text), expected, decimal_comma_question(text)),
                     where(column));
  }
  return *value;
}

}  // namespace artcal
