#include "app/history/time_labels.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/report/numbers.h"

namespace artcal {

TimeLabels time_labels(const std::vector<const HistoryEntry*>& entries) {
  TimeLabels times;
  for (const HistoryEntry* entry : entries) {
    const bool is_new = std::find(times.labels.begin(), times.labels.end(), entry->date) == times.labels.end();
    times.dated = times.dated && !entry->date.empty() && is_new;
    times.labels.push_back(entry->date);
  }
  for (std::size_t i = 0; !times.dated && i < times.labels.size(); ++i) {
    std::string& label = times.labels[i];
    label = fmt::format("{}: {}", i + 1, label.empty() ? "no date" : numbers::shown(label));
  }
  return times;
}

}  // namespace artcal
