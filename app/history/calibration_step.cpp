#include <algorithm>
#include <iterator>

#include "app/history/arm_history.h"

namespace artcal {

CalibrationStep step_between(const Calibration& then, const Calibration& now) {
  CalibrationStep step;
  static_cast<ParameterComparison&>(step) = compare(then, now);
  std::set_intersection(then.entry.certificates.begin(), then.entry.certificates.end(), now.entry.certificates.begin(),
                        now.entry.certificates.end(), std::back_inserter(step.in_common));
  if (then.arm && now.arm) {
    step.lengths = length_change(*then.arm, *now.arm);  // lengths compare where parameters do not
  }
  return step;
}

}  // namespace artcal
