#pragma once

#include "app/report/over_time/dated_results.h"
#include "app/report/sheet.h"

namespace artcal {

/// How the parameters of two or more identifications changed since the first, in its gauge
/// (app/results/drift/parameter_comparison.h).
void write_parameters_over_time(const DatedResults& identifications, Sheet& sheet);

}  // namespace artcal
