#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace artcal {

/// Rows of plain fields in text, one row a line: the body of every cloud that is text. Blank lines and lines
/// that begin with # or // are passed over.
class TextRows {
 public:
  /// What lies between two fields: any number of blanks and tabs, or one comma with or without blanks.
  enum class Separator { Blanks, Comma };

  /// The text must outlive the rows. `first_line` is the number that the text's first line has in the file.
  TextRows(std::string_view text, std::string path, int first_line, Separator separator)
      : rest_(text), path_(std::move(path)), separator_(separator), next_line_(first_line) {}

  /// Takes the next row; false at the end.
  bool next();
  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }
  /// What is behind the current row, from the start of a line, and that line's number.
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] int next_line() const { return next_line_; }

  /// The numbers in `columns` of this row; NaN and infinity are numbers here. Refused: fewer columns than
  /// that, anything that is not a number or too large for a double.
  Expected<void> numbers(const std::vector<std::size_t>& columns, double* values) const;
  [[nodiscard]] std::string where() const;  ///< "file:line"

 private:
  void split();

  std::string_view rest_;
  std::string_view line_;
  std::vector<std::string_view> fields_;
  std::string path_;
  Separator separator_;
  int line_number_ = 0;
  int next_line_;
};

/// The words of a header's line, separated by blanks and tabs; a carriage return at its end is no word.
std::vector<std::string_view> words_of(std::string_view line);

/// Whether the text reads as one number.
bool is_number(std::string_view text);

}  // namespace artcal
