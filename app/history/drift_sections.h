#pragma once

#include "app/history/arm_history.h"
#include "app/report/sheet.h"

namespace artcal {

/// How the parameters went since the first identification that is comparable with the last: pictures by unit, a table.
/// Nothing where there is no such pair.
void write_parameter_drift(const ArmHistory& history, Sheet& sheet);

/// By standard: the worst of each quantity over time, and the values that changed most. Nothing where no standard was
/// used twice.
void write_value_drift(const ArmHistory& history, Sheet& sheet);

}  // namespace artcal
