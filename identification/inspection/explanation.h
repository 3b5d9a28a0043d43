#pragma once

#include <string>
#include <vector>

#include "identification/identify.h"
#include "identification/inspection/as_written.h"
#include "identification/inspection/finding.h"

namespace artcal {

/// What explains the readings, and which mistakes were looked for in vain where nothing does.
struct Explanation {
  Findings findings;  ///< none, one, or a second mistake behind the first
  std::vector<std::string> excluded;
};

/// Tries what a recording would be without one mistake: angles, their order and signs, lengths and their units, radii,
/// labels, tables, a slipped encoder. The gross ones are ranked by the nominal arm, the others by quick fits. One is
/// named only where the whole search for an arm with it leaves a quarter of the residuals at most, and is a solution.
/// Where that is still more than a sound recording leaves, the same is asked of the recording without that mistake; and
/// where nothing explains the readings, of the recording without the gross mistake that brings them ten times nearer to
/// the nominal arm.
Explanation explain(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                    const AsWritten& as_written);

/// The same for diameters and radii alone, which takes a few fits.
Explanation explain_by_radii(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                             const AsWritten& as_written);

}  // namespace artcal
