#pragma once

#include <vector>

#include "artefacts/artefact/artefact.h"
#include "core/error.h"
#include "fitting/segmentation/segment.h"

namespace artcal {

/// What a scan of an artefact shows, and which feature of the artefact each part of it is.
struct ArtefactInScan {
  ScanContents contents;     ///< at the artefact's temperature
  std::vector<int> spheres;  ///< into Artefact::features, as ScanContents::radii counts them
  std::vector<int> planes;
};

/// Spheres and planes of an artefact at `temperature` (°C); distances between spheres as certified, else from
/// certified coordinates. Errors (BadInput): no sphere and no plane; a sphere without diameter; a distance between
/// spheres that leaves them no room.
Expected<ArtefactInScan> scan_contents(const Artefact& artefact, double temperature);

}  // namespace artcal
