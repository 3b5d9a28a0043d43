#pragma once

#include "artefacts/constraints/constraint.h"
#include "artefacts/scans/scan_readings.h"
#include "core/files/file_access.h"

namespace artcal {

/// read_constraints() of artefacts/constraints/constraint.h, where the artefacts may name certificates that `access`
/// allows; without it, those that FileAccess::beside() allows an artefact's file.
Expected<Constraints> read_constraints(Recording& recording, const FileAccess& access,
                                       const ScanSelection& selection = {});

}  // namespace artcal
