#pragma once

#include "artefacts/constraints/constraint.h"
#include "artefacts/dcc/writing/dcc_document.h"
#include "identification/identify.h"

namespace artcal {

/// An identified arm as a digital certificate: its parameters with U (k = 2), those that were kept, how far readings
/// and certified lengths are off before and after. States what cannot be determined, which certificates it rests on,
/// and every warning.
DccDocument dcc_of(const Recording& recording, const Constraints& constraints, const Identification& result,
                   const DccData& data);

}  // namespace artcal
