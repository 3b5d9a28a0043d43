#pragma once

#include <vector>

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// The lengths that an artefact's certificate states between balls or seats: its distances, or else those
/// between all features with certified coordinates (their u combined as if independent).
std::vector<CertifiedDistance> certified_lengths(const Artefact& artefact);

/// Adds the error of every certified length with both ends read in the same placement and repeat:
///     E = L/(1 + α·(T − T_ref)) − L_cal.
/// Ends that cannot be evaluated are told in `missing`. `quantity` is what the lengths count as.
void add_length_tests(const Session& session, Quantity quantity, Verification& verification);

}  // namespace artcal
