#pragma once

#include <nlohmann/json.hpp>

#include "artefacts/constraints/constraint.h"
#include "identification/inspection/inspection.h"

namespace artcal {

/// What an inspection says, as docs/result-schema.md describes it.
nlohmann::ordered_json to_json(const Recording& recording, const Constraints& constraints,
                               const Inspection& inspection);

/// A list of findings alone, as results of other commands carry it.
nlohmann::ordered_json findings_json(const Findings& findings);

}  // namespace artcal
