#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "app/history/arm_history.h"

namespace artcal {

VerificationStep step_between(const std::vector<PastVerification>& all, std::size_t then, std::size_t now) {
  VerificationStep step{then, now, compare(all[now].values, all[then].values), {}};
  const auto& earlier = all[then].entry.certificates;
  const auto& later = all[now].entry.certificates;
  std::set_intersection(earlier.begin(), earlier.end(), later.begin(), later.end(), std::back_inserter(step.in_common));
  return step;
}

std::size_t VerificationStep::told() const {
  return static_cast<std::size_t>(std::count_if(check.drifts.begin(), check.drifts.end(),
                                                [](const Drift& drift) { return drift.degrees_of_freedom > 0; }));
}

std::size_t VerificationStep::significant() const {
  return static_cast<std::size_t>(
      std::count_if(check.drifts.begin(), check.drifts.end(), [](const Drift& drift) { return drift.significant; }));
}

std::string change_in_words(const VerificationStep& step) {
  const std::size_t all = step.check.drifts.size(), told = step.told(), changed = step.significant();
  if (all == 0) {
    return "no value is in both";
  }
  if (told == 0) {
    return "without repeats nothing can be called significant";
  }
  return (changed > 0 ? fmt::format("{} of {} values changed significantly", changed, told)
                      : fmt::format("no significant change of {} values", told)) +
         (told < all ? fmt::format("; {} that were not repeated are not judged", all - told) : "");
}

}  // namespace artcal
