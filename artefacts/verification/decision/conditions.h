#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// Adds to `missing` what the conditions of the test lack for a statement of conformity: a temperature that
/// was not read or is outside the rated ones; and, where the decision rule needs u, certificates or a
/// specification that do not state what u is made of. Each is said once.
void check_conditions(const Session& session, Verification& verification);

/// Adds a warning for each value measured straight above the base or with a joint near its stop, told
/// together, and where the test is too coarse for its limit (guard band wider than the limit).
void add_place_warnings(Verification& verification);

}  // namespace artcal
