#pragma once

#include <string>
#include <vector>

#include "artefacts/artefact/artefact.h"

namespace artcal {

/// An artefact as the text of an artefact file (docs/files.md), in mm, with every digit: read back it is the same, but
/// for rounding of directions to unit length. Standard uncertainties u are written as U = 2·u with k = 2, those of zero
/// not at all. `comment` comes first, a line each, none of which may have a line end.
std::string artefact_file_text(const Artefact& artefact, const std::vector<std::string>& comment);

}  // namespace artcal
