#pragma once

#include "app/report/sheet.h"
#include "app/results/uncertainty/recorded_uncertainty.h"

namespace artcal {

/// What the identified arm measures like: lengths, a sphere, and a map over the working volume.
void write_uncertainty(const RecordedUncertainty& result, Sheet& sheet);

}  // namespace artcal
