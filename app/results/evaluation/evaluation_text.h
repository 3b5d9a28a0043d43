#pragma once

#include <string>
#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/evaluation/evaluation.h"

namespace artcal {

/// What a technician reads of an arm evaluated on readings: all together, by placement, by certified length, and the
/// largest deviations with file and line. REQUIRES: `recording.arm` is the arm evaluated.
std::string to_text(const Recording& recording, const Constraints& constraints, const Evaluation& evaluation,
                    const std::vector<std::string>& warnings);

}  // namespace artcal
