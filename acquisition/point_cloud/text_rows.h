#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/csv/cut_off.h"
#include "core/error.h"

namespace artcal {

/// Rows of plain fields in text, one row a line: the body of every cloud that is text. Blank lines and lines
/// that begin with # or // are passed over.
class TextRows {
 public:
  /// What lies between two fields: any number of blanks and tabs, or one comma or semicolon with or without blanks.
  /// Between semicolons a number may have a decimal comma, as spreadsheets of many countries write it.
  enum class Separator { Blanks, Comma, Semicolon };

  /// The text must outlive the rows. `first_line` is the number that the text's first line has in the file.
  TextRows(std::string_view text, std::string path, int first_line, Separator separator)
      : rest_(text), path_(std::move(path)), separator_(separator), watch_(text), next_line_(first_line) {}

  /// Takes the next row; false at the end.
  bool next();
  /// Splits the row at hand and those to come in this way.
  void separate_by(Separator separator);
  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }
  /// What is behind the current row, from the start of a line, and that line's number.
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] int next_line() const { return next_line_; }

  /// The numbers in `columns` of this row; NaN and infinity are numbers here, and 1.5D+02 is 150 as Fortran writes it.
  /// Refused: fewer columns than that, anything that is not a number or too large for a double, decimal points in one
  /// row and decimal commas in another.
  Expected<void> numbers(const std::vector<std::size_t>& columns, double* values);
  [[nodiscard]] bool is_number_at(std::size_t column) const;

  /// The numbers in `columns` of many rows to come, row behind row, read side by side on `threads` threads (0: as many
  /// as the machine has). None, and no row taken, where less than a megabyte is left, where more than `max_rows` rows
  /// would be taken, and where among the next megabytes is a row that has not `width` fields or not these numbers:
  /// next() and numbers() then come to that row and say what is wrong with it. What is taken does not depend on the
  /// number of threads.
  std::vector<double> take_many(const std::vector<std::size_t>& columns, std::size_t width, std::size_t max_rows,
                                int threads = 0);

  /// From now on messages may show what stands in the text: it is known to be a table of numbers. Its first row of
  /// numbers says so too.
  void allow_quotes() { quotes_ = true; }

  /// After the last row of numbers: a table that was cut off in its last number (acquisition/csv/cut_off.h), or
  /// warnings.
  [[nodiscard]] Expected<std::vector<std::string>> check_end() const { return watch_.judge(where()); }
  [[nodiscard]] std::string where() const;  ///< "file:line"

 private:
  void split();
  [[nodiscard]] bool decimal_signs_agree(std::string_view field);
  [[nodiscard]] std::string shown(std::string_view field) const;

  std::string_view rest_;
  std::size_t many_from_ = std::string_view::npos;  // take_many() tries again where no more than this is left
  std::string_view line_;
  std::vector<std::string_view> fields_;
  std::string path_;
  Separator separator_;
  bool has_points_ = false, has_commas_ = false;  // as decimal signs, between semicolons
  CutOffWatch watch_;
  bool ends_open_ = false;  // the text ends within this row's last field
  bool quotes_ = false;
  int line_number_ = 0;
  int next_line_;
};

/// The words of a header's line, separated by blanks and tabs; a carriage return at its end is no word.
std::vector<std::string_view> words_of(std::string_view line);

/// Whether the text reads as one number.
bool is_number(std::string_view text);

/// The text as a whole number without a sign, or nothing.
std::optional<std::size_t> whole_number(std::string_view text);

}  // namespace artcal
