#pragma once

#include <string>

#include "artefacts/artefact/artefact.h"
#include "core/toml/toml_document.h"

namespace artcal {

/// Reads [certificate] of artefact.toml. What it does not say is taken from the `digital` certificate that the file
/// names, if it does. Refused: a day that the calendar does not have, an end of validity before the calibration, what
/// contradicts the digital certificate.
Certificate read_certificate(TomlTable table, const Certificate& digital);

/// That an artefact's certificate had lapsed on that day, or was not yet valid; empty where it was valid.
std::string lapsed_text(const Artefact& artefact, const std::string& day);
std::string not_yet_valid_text(const Artefact& artefact, const std::string& day);

}  // namespace artcal
