#pragma once

#include <string>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/identify.h"

namespace artcal {

/// "none", "huber" or "cauchy".
Loss loss_named(const std::string& name);

/// What a recording asks of its own identification.
IdentifyOptions recorded_options(const Recording& recording);

/// identify() or identify_automatically(), with the warnings of all that was read before it.
Expected<Identification> run_identification(const Recording& recording, const Constraints& constraints,
                                            const IdentifyOptions& options);

}  // namespace artcal
