#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// Notes as missing what a statement of conformity rests on (ISO/IEC 17025, 6.5: metrological traceability) and the
/// session does not have: for every artefact whose certified values are in the test values a certificate with number
/// and date, valid on the day of the readings; the date of the readings; readings that the arm was not identified from.
void check_traceability(const Session& session, Verification& verification);

}  // namespace artcal
