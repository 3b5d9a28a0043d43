#pragma once

#include <string>
#include <vector>

#include "app/history/arm_history.h"

namespace artcal {

/// What points of time are called on an axis: their dates where each has one of its own, else their numbers with what
/// is known of the date.
struct TimeLabels {
  std::vector<std::string> labels;
  bool dated = true;
};

TimeLabels time_labels(const std::vector<const HistoryEntry*>& entries);

}  // namespace artcal
