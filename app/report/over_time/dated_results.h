#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "app/report/result_file.h"

namespace artcal {

/// Results of one kind in order of their dates; those without a date come first.
using DatedResults = std::vector<const nlohmann::ordered_json*>;
DatedResults of_kind(const std::vector<ReportedResult>& results, ResultKind kind);

/// What stands along an axis of time.
struct ResultTimes {
  nlohmann::ordered_json labels = nlohmann::ordered_json::array();  ///< dates, or "result 2"
  bool dated = true;
};

/// Dates where all are stated and differ; else the results' numbers.
ResultTimes times_of(const DatedResults& results);

}  // namespace artcal
