#pragma once

#include <string>
#include <vector>

#include "artefacts/artefact.h"
#include "core/toml_document.h"

namespace artcal {

/// Reads [certificate] of artefact.toml. What it does not say is taken from the `digital` certificate that the file
/// names, if it does. Refused: a day that the calendar does not have, an end of validity before the calibration, what
/// contradicts the digital certificate.
Certificate read_certificate(TomlTable table, const Certificate& digital);

/// What is wrong with the artefacts' certificates on the day of the measurement ("2026-03-10"): lapsed before it, or
/// calibrated after it. Nothing where the day is not known (empty): the clock of this computer is not asked.
std::vector<std::string> certificate_warnings(const std::vector<Artefact>& artefacts, const std::string& day);

}  // namespace artcal
