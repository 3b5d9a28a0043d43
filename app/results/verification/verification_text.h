#pragma once

#include <string>

#include "artefacts/verification/session.h"
#include "artefacts/verification/verify.h"

namespace artcal {

/// The answer first, then what it rests on. Long lists are shortened to what does not conform and the worst of
/// the rest, unless `all` is asked for.
std::string to_text(const Session& session, const VerificationResult& result, bool all);

}  // namespace artcal
