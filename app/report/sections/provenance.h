#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "app/report/result_file.h"
#include "app/report/sheet.h"

namespace artcal {

/// What was measured with what, when, at what temperature and by which certificates; and what was warned of.
/// Throws std::exception where the JSON is not as docs/result-schema.md says.
void write_circumstances(const nlohmann::ordered_json& result, Sheet& sheet);

/// The files behind each result with their hashes, and the program that made it.
void write_provenance(const std::vector<ReportedResult>& results, Sheet& sheet);

}  // namespace artcal
