#pragma once

#include <algorithm>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/report/recorded_result.h"

namespace artcal {

/// Results of one kind in order of their dates; those without a date come first. They refer to the results they are of.
using DatedResults = std::vector<const RecordedResult*>;

template <typename Content>
DatedResults dated(const std::vector<RecordedResult>& results) {
  DatedResults found;
  for (const RecordedResult& result : results) {
    if (std::holds_alternative<Content>(result.content)) {
      found.push_back(&result);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const RecordedResult* a, const RecordedResult* b) { return a->head.date < b->head.date; });
  return found;
}

/// What stands along an axis of time.
struct ResultTimes {
  nlohmann::ordered_json labels = nlohmann::ordered_json::array();  ///< dates, or "result 2"
  bool dated = true;
};

/// Dates where all are stated and differ; else the results' numbers.
ResultTimes times_of(const DatedResults& results);

}  // namespace artcal
