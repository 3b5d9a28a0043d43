#pragma once

#include "artefacts/constraints/constraint.h"

namespace artcal {

/// Gives every feature its unknowns: fills Constraints::groups and shared, and the indices into them. Unknown
/// points are grouped by the distances that tie them together, what is posed by its artefact's placement,
/// unknown planes by the distances too, which also make them parallel.
void assign_unknowns(Constraints& constraints);

}  // namespace artcal
