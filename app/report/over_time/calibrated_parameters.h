#pragma once

#include "app/results/drift/parameter_comparison.h"
#include "app/results/identification/recorded/recorded_identification.h"

namespace artcal {

/// The parameters of an identification's result.
CalibratedParameters calibrated_parameters(const RecordedIdentification& identification);

}  // namespace artcal
