#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files/input_file.h"

namespace artcal {

/// What a report can show.
enum class ResultKind { Identification, Verification, Uncertainty, MonteCarlo };

/// One result as JSON (docs/result-schema.md), and where it came from.
struct ReportedResult {
  ResultKind kind = ResultKind::Identification;
  nlohmann::ordered_json json;
  std::string path;  ///< empty where it was not read from a file
};

/// Takes a result that was just computed. REQUIRES: it is of one of these kinds.
ReportedResult reported(nlohmann::ordered_json json);

/// Reads a file that `--json` wrote and notes it as an input. Refused: what is no result, another version of the
/// schema, a kind of which there is no report.
Expected<ReportedResult> read_result(const std::string& path, std::vector<InputFile>& inputs);

}  // namespace artcal
