#include "app/report/over_time/dated_results.h"

#include <string>

#include <fmt/format.h>

namespace artcal {

ResultTimes times_of(const DatedResults& results) {
  ResultTimes times;
  std::string last;
  for (const RecordedResult* result : results) {
    const std::string& date = result->head.date;
    times.dated = times.dated && !date.empty() && date != last;
    last = date;
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    times.labels.push_back(times.dated ? results[i]->head.date : fmt::format("result {}", i + 1));
  }
  return times;
}

}  // namespace artcal
