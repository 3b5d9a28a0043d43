#pragma once

#include <string>

#include "acquisition/import/imported_readings.h"

namespace artcal {

/// What was understood of a file, for a person to check: format, columns, the first rows and the range of each number.
std::string import_preview(const std::string& path, const ImportedReadings& readings);

}  // namespace artcal
