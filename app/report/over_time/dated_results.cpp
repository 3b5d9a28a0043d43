#include "app/report/over_time/dated_results.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "app/report/numbers.h"

namespace artcal {

using Json = nlohmann::ordered_json;
using numbers::text_in;

DatedResults of_kind(const std::vector<ReportedResult>& results, ResultKind kind) {
  DatedResults found;
  for (const ReportedResult& result : results) {
    if (result.kind == kind) {
      found.push_back(&result.json);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Json* a, const Json* b) { return text_in(*a, "date") < text_in(*b, "date"); });
  return found;
}

ResultTimes times_of(const DatedResults& results) {
  ResultTimes times;
  std::string last;
  for (const Json* result : results) {
    const std::string date = text_in(*result, "date");
    times.dated = times.dated && !date.empty() && date != last;
    last = date;
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    times.labels.push_back(times.dated ? text_in(*results[i], "date") : fmt::format("result {}", i + 1));
  }
  return times;
}

}  // namespace artcal
