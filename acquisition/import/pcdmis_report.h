#pragma once

#include "acquisition/import/imported_readings.h"

namespace artcal {

/// Whether the text is a PC-DMIS report: a line of it begins with DIM and states a LOCATION.
bool is_pcdmis_report(const TextFile& file);

/// The coordinates of a PC-DMIS text report: of each `DIM … = LOCATION OF kind NAME UNITS=MM` the values under MEAS in
/// the lines X, Y, Z. Other dimensions and axes (D, R, T …) are passed over, and said to be.
///
/// Bad input: a location without a table or without one of X, Y, Z; a value that is no number; two units in one file.
Expected<ImportedReadings> import_pcdmis_report(const TextFile& file);

}  // namespace artcal
