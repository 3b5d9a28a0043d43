#pragma once

#include <string>
#include <vector>

#include "artefacts/constraints/constraint.h"
#include "artefacts/verification/verification.h"
#include "identification/identify.h"
#include "identification/inspection/inspection.h"

namespace artcal {

/// An inspection of a recording that was read, with what the reading itself left out: repeated rows.
/// inspect() of identification/inspection/inspection.h where `options` are given, else inspect_recording().
/// What becomes a finding is taken out of recording.warnings.
Inspection inspected(Recording& recording, const Constraints& constraints, const IdentifyOptions* options);

/// An identification, and what an inspection finds. Where no arm fits, or one fits far better without one mistake, that
/// mistake is the error; --accept-misfit returns the fit and carries it as a finding. The result has the warnings of
/// what was read before it, and findings as warnings too.
struct InspectedIdentification {
  Expected<Identification> result;
  Findings findings;
};
/// `result` is what identify() gave with these options.
InspectedIdentification inspect_result(Expected<Identification> result, const Recording& recording,
                                       const Constraints& constraints, const IdentifyOptions& options);

/// What an inspection finds in the recording of a verification: with the hypotheses that need a fit only where the arm
/// that is judged is more than 0.3 mm rms off its readings, as no sound one is.
Findings findings_for_verification(Recording& recording, const Constraints& constraints, const Arm& arm);

/// Values of the specification and the limits that cannot be, as `verify` finds them: findings about the documents.
Findings findings_of_verification(const std::vector<MissingEvidence>& evidence);

}  // namespace artcal
