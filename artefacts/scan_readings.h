#pragma once

#include <vector>

#include "acquisition/recording.h"
#include "artefacts/artefact.h"
#include "core/error.h"

namespace artcal {

/// Makes readings of the scans that a recording names (Recording::scans): each point that lies on a sphere of the
/// artefact becomes a contact reading on it, its line the point's row in the file, from 1. The spheres are looked for
/// among the tip's positions as the recording's arm gives them from q1 … qn, with the ball's radius and the tip's
/// together; x, y, z of the file are not used. The arm is nominal, and may see spheres somewhat out of round and their
/// distances changed. Notes each file as an input of the recording, and how much of it was used as a warning.
///
/// Errors, naming the scan: BadInput for a file that cannot be read, has no joint angles or those of another arm, is
/// named twice; for an artefact, sphere or probe that is not there, or an artefact without spheres of known diameter.
/// NoSolution where no sphere is found, none of the certified distances fit, or several ways of naming them fit.
/// After an error the recording may hold part of the scans and is of no use.
Expected<void> read_scans(Recording& recording, const std::vector<Artefact>& artefacts);

}  // namespace artcal
