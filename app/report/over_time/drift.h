#pragma once

#include <vector>

#include "app/report/result_file.h"
#include "app/report/sheet.h"

namespace artcal {

/// How the arm changed over several results of one kind, in order of their dates: parameters of identifications, those
/// of all in the gauge of the first (app/results/drift/gauge.h), and the worst value of each quantity of
/// verifications by the same standard. Where there is only one result of a kind, nothing. Throws std::exception where
/// the JSON is not as the schema says.
void write_drift(const std::vector<ReportedResult>& results, Sheet& sheet);

}  // namespace artcal
