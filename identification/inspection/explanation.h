#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/identify.h"
#include "identification/inspection/as_written.h"
#include "identification/inspection/finding.h"

namespace artcal {

/// What one mistake explains, and which mistakes were looked for in vain.
struct Explanation {
  std::optional<Finding> finding;
  std::vector<std::string> excluded;
};

/// Tries what a recording would be without one mistake: angles, their order and signs, lengths and their units, radii,
/// labels, tables, a slipped encoder. The gross ones are ranked by the nominal arm, the others by quick fits. One is
/// named only where the whole search for an arm with it leaves a quarter of the residuals at most, and is a solution.
Explanation explain(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                    const AsWritten& as_written);

/// The same for diameters and radii alone, which takes a few fits.
Explanation explain_by_radii(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                             const AsWritten& as_written);

}  // namespace artcal
