#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/files/text_file.h"

namespace artcal {

/// What lies between the fields of a text table. Blanks: any number of blanks and tabs.
enum class Delimiter { Semicolon, Tab, Comma, Blanks };

/// The word for it, as messages use it.
std::string_view name_of(Delimiter delimiter);

struct DelimitedRow {
  int line = 0;                     ///< in the file, from 1
  std::vector<std::string> fields;  ///< without the blanks and the quotes around them
  std::vector<int> columns;         ///< where each begins, in characters from 1
};

/// A table as another program exported it.
struct DelimitedText {
  Delimiter delimiter = Delimiter::Comma;
  std::vector<DelimitedRow> rows;
};

/// Splits a text into rows and fields. Blank lines and lines that begin with # are passed over, and the first `skipped`
/// lines. A field in double quotes may hold delimiters, and a quote as "". Without a delimiter the first row decides: a
/// semicolon in it, else a tab, else a comma that is no decimal comma between blanks, else blanks.
///
/// Bad input: a quote that is not closed, text behind a closing quote, rows of different length, no rows.
Expected<DelimitedText> split_text(const TextFile& file, std::optional<Delimiter> delimiter, int skipped = 0);

/// A number as CSV has it, its digits unchanged: "-12,50" as "-12.50", "+1.5D+02" as "1.5E+02". Nothing for what is
/// none: thousands separators, NaN, infinity. `has_comma` is set where the decimal sign is a comma, `has_point` where
/// it is a point.
std::optional<std::string> number_text(std::string_view field, bool& has_comma, bool& has_point);

}  // namespace artcal
