#pragma once

#include "artefacts/verification/verification.h"

namespace artcal {

/// Applies the rule that a few bad values may be measured again. A set is one length in one position; its
/// first `repeats` values are the plan's, further ones the repetition. Where at most rule.values of a set do
/// not conform and it was repeated at least rule.again times, all of which conform, the bad values are set
/// aside, in at most rule.sets sets. Nothing is done where the repetition is missing or fails.
void set_outliers_aside(const OutlierRule& rule, int repeats, Verification& verification);

}  // namespace artcal
