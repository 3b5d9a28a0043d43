#pragma once

#include <string>
#include <vector>

#include "artefacts/artefact.h"
#include "core/toml_document.h"

namespace artcal {

/// Reads [certificate] of artefact.toml. Refused: a day that the calendar does not have, an end of validity before the
/// calibration.
Certificate read_certificate(TomlTable table);

/// What is wrong with the artefacts' certificates on the day of the measurement ("2026-03-10"): lapsed before it, or
/// calibrated after it. Nothing where the day is not known (empty): the clock of this computer is not asked.
std::vector<std::string> certificate_warnings(const std::vector<Artefact>& artefacts, const std::string& day);

}  // namespace artcal
