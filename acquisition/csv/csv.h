#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/csv/cut_off.h"
#include "core/error.h"
#include "core/files/text_file.h"

namespace artcal {

/// Reads comma-separated text (RFC 4180) row by row and knows where every field stands. Windows line
/// ends, quoted fields, blank lines and lines that begin with # are taken as they come.
class CsvReader {
 public:
  /// Reads the header. Refused: no header, an empty or a doubled column name, another separator.
  /// The file must outlive the reader.
  static Expected<CsvReader> open(const TextFile& file) {
    return open(file, [](const auto&) { return ""; });
  }
  /// Why a header is none of the expected kind of table, empty where it is one: asked before anything in it is quoted.
  using HeaderKind = std::function<std::string(const std::vector<std::string>&)>;
  static Expected<CsvReader> open(const TextFile& file, const HeaderKind& kind);

  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;

  /// Reads the next row; false at the end. A row with another number of fields than the header is an
  /// error.
  Expected<bool> next();

  /// After the last row: a table that was cut off in its last number (acquisition/csv/cut_off.h), or warnings.
  [[nodiscard]] Expected<std::vector<std::string>> check_end() const { return watch_.judge(where_line()); }

  /// REQUIRES: column < header().size(), and next() returned true.
  [[nodiscard]] std::string_view field(std::size_t column) const { return fields_[column]; }
  /// A finite number, or an error that says what stands there instead; `expected` ends its sentence.
  [[nodiscard]] Expected<double> number(std::size_t column, std::string_view expected) const;

  [[nodiscard]] int line() const { return line_; }  ///< of the row, from 1
  /// "file:line:column", the column counted in characters from 1.
  [[nodiscard]] std::string where(std::size_t column) const;

 private:
  explicit CsvReader(const TextFile& file) : path_(file.path.string()), rest_(file.text), watch_(file.text) {}
  [[nodiscard]] std::string where_line() const;
  [[nodiscard]] std::string where_byte(std::size_t offset) const;
  Expected<bool> read_row();
  Expected<void> read_field();
  Expected<void> check_header(const HeaderKind& kind);

  std::string path_;
  std::string_view rest_;
  std::string_view row_;
  std::vector<std::string> header_;
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> starts_;
  CutOffWatch watch_;
  bool ends_open_ = false;            // the text ends within this row's last field
  std::deque<std::string> unquoted_;  // owns fields whose doubled quotes had to be undone
  int line_ = 0;
  int next_line_ = 1;
};

}  // namespace artcal
