#pragma once

#include <string>

#include "artefacts/scan_contents.h"

namespace artcal {

/// Why a scan of a recording tells no spheres, and what to do, in one sentence. REQUIRES: its status is neither
/// Complete nor Partial.
std::string scan_refusal(const Segmentation& found, const ArtefactInScan& wanted, const Artefact& artefact);

}  // namespace artcal
