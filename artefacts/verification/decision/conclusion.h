#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// What ends every test, whichever document it follows, once all values are judged: what is missing for conformity
/// (plausible limits and uncertainties, traceability, conditions), warnings of places, and the conclusion.
void check_and_conclude(const Session& session, Verification& verification);

}  // namespace artcal
