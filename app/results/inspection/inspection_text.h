#pragma once

#include <string>

#include "artefacts/constraints/constraint.h"
#include "identification/inspection/inspection.h"

namespace artcal {

/// What an inspection says, for a person: findings first, then remarks, then what of the arm was used.
std::string to_text(const Recording& recording, const Constraints& constraints, const Inspection& inspection);

/// Findings of which the input's warnings say nothing, under a heading; nothing where there are none.
std::string further_findings_text(const Findings& findings);

}  // namespace artcal
