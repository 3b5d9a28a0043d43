#pragma once

#include "identification/identify.h"
#include "tests/support/probing/session.h"

namespace artcal::probing {

enum class Outcome { Found, Refused, Wrong };

/// Found: lengths in the volume agree with the truth within 0.05 mm rms or, where the readings do not determine them so
/// well, within four times what the covariance of the result says of them. Wrong: a result that does not.
Outcome outcome(const Session& session, const Expected<Identification>& result);

/// What the covariance of a result says of length_error(), by numerical derivatives of this chain.
double stated_length_error(const Identification& result);

}  // namespace artcal::probing
