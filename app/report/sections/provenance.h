#pragma once

#include <vector>

#include "app/report/recorded_result.h"
#include "app/report/sheet.h"

namespace artcal {

/// What was measured with what, when, at what temperature and by which certificates; and what was warned of.
void write_circumstances(const RecordedHead& head, const RecordedCircumstances& circumstances, Sheet& sheet);

/// The files behind each result with their hashes, and the program that made it.
void write_provenance(const std::vector<RecordedResult>& results, Sheet& sheet);

}  // namespace artcal
