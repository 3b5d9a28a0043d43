#include "artefacts/verification/decision/conclusion.h"

#include "artefacts/verification/decision/conditions.h"
#include "artefacts/verification/decision/plausibility_of_test.h"
#include "artefacts/verification/decision/traceability.h"

namespace artcal {

void check_and_conclude(const Session& session, Verification& verification) {
  check_plausibility(session, verification);
  check_traceability(session, verification);
  check_conditions(session, verification);
  add_place_warnings(verification);
  verification.conclusion = conclude(verification);
}

}  // namespace artcal
