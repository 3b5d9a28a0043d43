#pragma once

#include "artefacts/dcc/writing/dcc_document.h"
#include "artefacts/verification/session.h"
#include "artefacts/verification/verify.h"

namespace artcal {

/// A verification as a digital certificate: every value with U (k = 2), its limit, the rule and the verdict, plates
/// and drifts. States the conclusion, what stands in its way, which files and certificates it rests on, every warning.
DccDocument dcc_of(const Session& session, const VerificationResult& result, const DccData& data);

}  // namespace artcal
