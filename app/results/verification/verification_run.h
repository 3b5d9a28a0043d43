#pragma once

#include <string>

#include "app/results/verification/verification_material.h"
#include "artefacts/verification/verify.h"

namespace artcal {

/// Judges an arm, with the warnings of all that was read before it. An empty standard is the recording's; `against` is
/// the result of an earlier verification, or empty. Usage: neither caller nor recording name a standard.
Expected<VerificationResult> run_verification(VerificationMaterial& material, const std::string& standard,
                                              const std::string& against);

/// Whether conformity is shown; of an interim check, whether no drift is.
bool is_shown(const VerificationResult& result);

}  // namespace artcal
