#pragma once

#include "artefacts/artefact/artefact.h"
#include "artefacts/artefact/artefact_values.h"

namespace artcal {

/// Reads one table [[feature]] of artefact.toml.
CertifiedFeature read_feature(TomlTable& table, const ArtefactValues& values);

}  // namespace artcal
