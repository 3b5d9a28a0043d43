#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// Notes as missing (plausible_values) what cannot be: of certificates, temperatures and tips that the values rest on
/// (artefacts/artefact/plausibility.h), and of the specification: limits and uncertainties of another order of
/// magnitude than arms have, rated temperatures of no laboratory, a measuring range that is not the arm's. A verdict by
/// such numbers would look right.
void check_plausibility(const Session& session, Verification& verification);

}  // namespace artcal
