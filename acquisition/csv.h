#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/text_file.h"

namespace artcal {

/// Reads comma-separated text (RFC 4180) row by row and knows where every field stands. Windows line
/// ends, quoted fields, blank lines and lines that begin with # are taken as they come.
class CsvReader {
 public:
  /// Reads the header. Refused: no header, an empty or a doubled column name, another separator.
  /// The file must outlive the reader.
  static Expected<CsvReader> open(const TextFile& file);

  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;

  /// Reads the next row; false at the end. A row with another number of fields than the header is an
  /// error.
  Expected<bool> next();

  /// REQUIRES: column < header().size(), and next() returned true.
  [[nodiscard]] std::string_view field(std::size_t column) const { return fields_[column]; }
  /// A finite number, or an error that says what stands there instead; `expected` ends its sentence.
  [[nodiscard]] Expected<double> number(std::size_t column, std::string_view expected) const;

  [[nodiscard]] int line() const { return line_; }  ///< of the row, from 1
  /// "file:line:column", the column counted in characters from 1.
  [[nodiscard]] std::string where(std::size_t column) const;

 private:
  explicit CsvReader(const TextFile& file) : path_(file.path.string()), rest_(file.text) {}
  [[nodiscard]] std::string where_byte(std::size_t offset) const;
  Expected<bool> read_row();
  Expected<void> read_field();
  Expected<void> check_header();

  std::string path_;
  std::string_view rest_;
  std::string_view row_;
  std::vector<std::string> header_;
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> starts_;
  std::deque<std::string> unquoted_;  // owns fields whose doubled quotes had to be undone
  int line_ = 0;
  int next_line_ = 1;
};

}  // namespace artcal
