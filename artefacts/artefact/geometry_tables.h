#pragma once

#include "artefacts/artefact/artefact.h"
#include "artefacts/artefact/artefact_values.h"

namespace artcal {

/// Reads the tables [[feature]] and [[distance]] of artefact.toml into an artefact whose other fields are read, and
/// refuses what they say of one another (artefacts/artefact/consistency) where they say it.
void read_geometry(TomlTable& root, const ArtefactValues& values, Artefact& artefact);

}  // namespace artcal
