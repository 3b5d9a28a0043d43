#include "app/results/identification/input_warnings.h"

#include <string>
#include <utility>

namespace artcal {

Expected<Identification> with_input_warnings(Expected<Identification> result, const Recording& recording,
                                             const Constraints& constraints) {
  if (!result) {
    return tl::unexpected(with_warnings(std::move(result.error()), recording.warnings));
  }
  auto& warnings = result->warnings;
  for (const std::string& reason : result->misfits) {
    warnings.insert(warnings.begin(), "this arm is no solution of its readings (--accept-misfit): " + reason);
  }
  warnings.insert(warnings.begin(), constraints.warnings.begin(), constraints.warnings.end());
  warnings.insert(warnings.begin(), recording.warnings.begin(), recording.warnings.end());
  return result;
}

}  // namespace artcal
