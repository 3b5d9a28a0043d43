#pragma once

#include <vector>

#include "artefacts/artefact/artefact.h"
#include "artefacts/artefact/artefact_values.h"

namespace artcal {

/// Reads one table [[distance]] of artefact.toml: one distance `between` two features, or several `along` a row of
/// them. REQUIRES: the artefact's features have been read.
std::vector<CertifiedDistance> read_distances(TomlTable& table, const Artefact& artefact, const ArtefactValues& values);

}  // namespace artcal
