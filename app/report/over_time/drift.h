#pragma once

#include <vector>

#include "app/report/recorded_result.h"
#include "app/report/sheet.h"

namespace artcal {

/// How the arm changed over several results of one kind, in order of their dates: parameters of identifications, those
/// of all in the gauge of the first (app/results/drift/gauge.h), and the worst value of each quantity of
/// verifications by the same standard. Where there is only one result of a kind, nothing.
void write_drift(const std::vector<RecordedResult>& results, Sheet& sheet);

}  // namespace artcal
