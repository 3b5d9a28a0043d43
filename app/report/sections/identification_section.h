#pragma once

#include "app/report/sheet.h"
#include "app/results/identification/recorded/recorded_identification.h"

namespace artcal {

/// What an identification came to, for the top of a report.
void write_identification_verdict(const RecordedIdentification& result, Sheet& sheet);

/// An identification: before and after, parameters, what could not be determined, pictures.
void write_identification(const RecordedIdentification& result, Sheet& sheet);

}  // namespace artcal
