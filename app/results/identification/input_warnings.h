#pragma once

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/identify.h"

namespace artcal {

/// An identification or its error, with the warnings of all that was read before it.
Expected<Identification> with_input_warnings(Expected<Identification> result, const Recording& recording,
                                             const Constraints& constraints);

}  // namespace artcal
