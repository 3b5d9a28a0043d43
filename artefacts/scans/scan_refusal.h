#pragma once

#include <string>

#include "artefacts/scans/scan_contents.h"

namespace artcal {

/// Why a scan of a recording tells no spheres, and what to do, in one sentence. REQUIRES: its status is neither
/// Complete nor Partial, and `hints` are those that it was made with.
std::string scan_refusal(const Segmentation& found, const ArtefactInScan& wanted, const Artefact& artefact,
                         const std::vector<PlaceHint>& hints);

}  // namespace artcal
