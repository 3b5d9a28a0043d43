#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/batch/batch.h"

namespace artcal {

/// What a person reads at the end: the counts, then what failed and why.
std::string to_text(const BatchSummary& summary, const std::string& store);

/// How far an interrupted batch came, and how to go on. REQUIRES: summary.not_reached > 0.
std::string interruption_text(const BatchSummary& summary, const std::string& store);

/// Why the exit code is above 1, in one line. REQUIRES: it is.
std::string failure_line(const BatchSummary& summary);

/// The table `batch` of docs/result-schema.md.
nlohmann::ordered_json to_json(const BatchSummary& summary, const std::string& store);

}  // namespace artcal
