#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/import/delimited_text.h"
#include "core/error.h"

namespace artcal {

/// Readings of another program's file as a table of readings.csv. Numbers keep their digits and their unit.
struct ImportedReadings {
  std::string format;                          ///< what the file was taken for
  std::vector<std::string> columns;            ///< columns of readings.csv
  std::vector<std::vector<std::string>> rows;  ///< a field each, numbers with decimal points
  std::vector<std::string> understood;         ///< sentences: which columns were used, what was passed over
  std::string length_unit;                     ///< where the file states it; else empty
};

struct TextImport {
  std::string columns;  ///< stated_roles(); empty: by the header
  std::optional<Delimiter> delimiter;
  int skipped = 0;  ///< lines above the table
};

/// Reads a text table: any delimiter, decimal points or commas, quotes, a header or stated columns.
///
/// Bad input: what split_text() refuses; no header where no columns are stated; decimal points and decimal commas in
/// one file; a field that is no number where one is expected; a column for x that counts the rows.
Expected<ImportedReadings> import_text(const TextFile& file, const TextImport& options);

/// The table as readings.csv.
std::string readings_csv(const ImportedReadings& readings);

}  // namespace artcal
