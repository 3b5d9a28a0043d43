#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// The quantities of ISO 10360-12 from a recording: P_Size, P_Form and L_Dia on single balls, E_Uni on
/// everything else (bars, plates), E_Bi on parallel faces, judged by the specification, and what is missing
/// for conformity. The text of the standard was not at hand: docs/verification.md says what each number rests
/// on. Refused: a recording in which nothing can be evaluated.
Expected<Verification> verify_iso10360_12(const Session& session);

}  // namespace artcal
