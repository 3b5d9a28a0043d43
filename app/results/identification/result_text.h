#pragma once

#include <string>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/identify.h"

namespace artcal {

/// What a technician reads: the answer first, then what it rests on, then what to beware of.
std::string to_text(const Recording& recording, const Constraints& constraints, const Identification& result);

}  // namespace artcal
