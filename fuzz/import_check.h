#pragma once

#include "acquisition/import/imported_readings.h"
#include "fuzz/check.h"

namespace artcal::fuzzing {

/// An import is refused in one sentence, or is a table of as many fields in each row as columns.
inline void check_import(const Expected<ImportedReadings>& readings) {
  if (!readings) {
    require_sentence(readings.error());
    return;
  }
  require(!readings->rows.empty());
  for (const auto& row : readings->rows) {
    require(row.size() == readings->columns.size());
  }
  require(!readings_csv(*readings).empty());
}

}  // namespace artcal::fuzzing
