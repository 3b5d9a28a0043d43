#pragma once

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "artefacts/scans/scan_readings.h"
#include "core/error.h"
#include "core/files/file_access.h"

namespace artcal {

/// A recording and what its artefacts demand of its readings, which the constraints name by their index.
struct BoundRecording {
  Recording recording;  ///< with the artefact files among its inputs and readings of its scans, repeated ones left out
  Constraints constraints;
};

/// Reads the artefact files that a recording names, makes readings of its scans (artefacts/scans/scan_readings.h),
/// leaves out readings that repeat another one, and builds the constraints. The message of an error ends with what
/// looks wrong in the input, Recording::warnings: the cause may be there.
Expected<BoundRecording> bind_recording(Recording recording, const ScanSelection& selection = {});
/// The same, where the artefacts may name certificates that `access` allows; without it, all files.
Expected<BoundRecording> bind_recording(Recording recording, const FileAccess& access,
                                        const ScanSelection& selection = {});

}  // namespace artcal
